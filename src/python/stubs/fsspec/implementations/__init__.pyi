from fsspec.implementations import local as local
