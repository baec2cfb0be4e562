# What tank_datum uses of psutil, which has no types of its own.
class Memory:
    available: int

def virtual_memory() -> Memory: ...
