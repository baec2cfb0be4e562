import os
from typing import Any

def write_table(table: Any, where: str | os.PathLike[str]) -> None: ...
