# What tank_datum uses of pye57, which has no types.
from pye57 import libe57 as libe57
