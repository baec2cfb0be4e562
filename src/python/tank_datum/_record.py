"""Typed views of JSON: dicts whose keys are attributes, and what a value must be to be one."""

from __future__ import annotations

from functools import lru_cache
from types import UnionType
from typing import (
    TYPE_CHECKING,
    Any,
    Self,
    TypeVar,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

_SCALARS: dict[Any, tuple[type, ...]] = {
    float: (int, float),
    int: (int,),
    str: (str,),
    bool: (bool,),
}


class Misfit(Exception):
    """A value of JSON is of another kind than its place wants: "tank.radius", "a text"."""

    def __init__(self, place: str, kind: str, wanted: str) -> None:
        super().__init__(f"{place}, {kind}, expected {wanted}")
        self.place, self.kind, self.wanted = place, kind, wanted


class Record(dict[str, Any]):
    """A dict whose keys are attributes: `tilt.slope` is `tilt["slope"]`.

    One that is declared as `... | None` is None where the file does not have it.
    """

    if not TYPE_CHECKING:  # what is declared is known; a slip is to be found

        def __getattr__(self, name: str) -> Any:
            if name in self or _is_optional(_declared(type(self)).get(name)):
                return self.get(name)
            raise AttributeError(f"{type(self).__name__} has no {name!r}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        shown = ", ".join(f"{key}={_short(value)}" for key, value in self.items())
        return f"{type(self).__name__}({shown})"

    def copy(self) -> Self:
        return type(self)(self)


R = TypeVar("R", bound=Record)


def record_of(kind: type[R], value: Any, place: str = "") -> R:
    """A dict of JSON as a record, with those inside it. Raises Misfit.

    Keys that the record does not declare are kept. Declared ones may be missing or null when they
    are declared so; a number may be null, which is not known.
    """
    if not isinstance(value, dict):
        raise _misfit(value, place, "an object")
    hints = _declared(kind)
    within = f"{place}." if place else ""
    for name, declared in hints.items():
        if name not in value and not _is_optional(declared):
            raise Misfit(f"{within}{name}", "nothing", "a value")
    return kind(
        {k: _typed(hints.get(k, Any), v, f"{within}{k}") for k, v in value.items()}
    )


@lru_cache
def _declared(kind: type[Record]) -> dict[str, Any]:
    return get_type_hints(kind)


def _is_optional(kind: Any) -> bool:
    return get_origin(kind) in (Union, UnionType)


def _typed(kind: Any, value: Any, place: str) -> Any:
    if value is None and (kind in (Any, float) or _is_optional(kind)):
        return None
    if kind is Any:
        return _named(value)
    if _is_optional(kind):
        kind = next(one for one in get_args(kind) if one is not type(None))
    if isinstance(kind, type) and issubclass(kind, Record):
        return record_of(kind, value, place)
    if get_origin(kind) is list:
        if not isinstance(value, list):
            raise _misfit(value, place, "a list")
        (inner,) = get_args(kind)
        return [_typed(inner, one, f"{place}[{i}]") for i, one in enumerate(value)]
    if get_origin(kind) is dict:
        if not isinstance(value, dict):
            raise _misfit(value, place, "an object")
        return _named(value)
    allowed = _SCALARS[kind]
    if not isinstance(value, allowed) or (isinstance(value, bool) and kind is not bool):
        raise _misfit(value, place, _name(allowed[-1]))
    return value


def _named(value: Any) -> Any:
    """What is not declared: its dicts are records."""
    if isinstance(value, dict):
        return Record({key: _named(inner) for key, inner in value.items()})
    return [_named(one) for one in value] if isinstance(value, list) else value


def _name(kind: type) -> str:
    names = {dict: "an object", list: "a list", str: "a text", bool: "true or false"}
    names |= {int: "a whole number", type(None): "null"}
    return names.get(kind, "a number")


def _misfit(value: object, place: str, wanted: str) -> Misfit:
    return Misfit(place or "the whole", _name(type(value)), wanted)


def _short(value: object) -> str:
    if isinstance(value, list) and len(value) > 4:
        return f"[{len(value)} values]"
    return f"{value:.6g}" if isinstance(value, float) else repr(value)
