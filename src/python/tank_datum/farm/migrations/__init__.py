"""The history's tables, version after version: Alembic's scripts."""
