# What tank_datum uses of pye57's libe57: nodes are got by name or number, and are what the file makes them.
from typing import Any

from numpy.typing import NDArray

E57_SINGLE: Any
CHECKSUM_POLICY_NONE: Any

class StructureNode:
    def __init__(self, node: Any) -> None: ...
    def __getitem__(self, name: str | int) -> Any: ...
    def isDefined(self, path: str) -> bool: ...
    def childCount(self) -> int: ...

class ScaledIntegerNode:
    def scale(self) -> float: ...

class FloatNode:
    def precision(self) -> Any: ...

class SourceDestBuffer:
    def __init__(
        self,
        image: ImageFile,
        path: str,
        values: NDArray[Any],
        capacity: int,
        convert: bool,
        scale: bool,
    ) -> None: ...

class VectorSourceDestBuffer:
    def __init__(self) -> None: ...
    def append(self, buffer: SourceDestBuffer) -> None: ...

class ImageFile:
    def __init__(self, path: str, mode: str, checksums: Any = ...) -> None: ...
    def root(self) -> StructureNode: ...
