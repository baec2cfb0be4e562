"""What can be wrong with a campaign, told so that a person finds the place."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Problem:
    """Something wrong in a campaign's file. line: 1 for the first; 0 when there is no line."""

    file: str
    line: int
    reason: str

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        return f"{place}: {self.reason}"


class CampaignError(ValueError):
    """A campaign that cannot be run; `problems` holds every reason, in the file's order."""

    def __init__(self, problems: list[Problem]) -> None:
        super().__init__("\n".join(str(problem) for problem in problems))
        self.problems = problems


class FarmError(RuntimeError):
    """Storage, database or scheduler that cannot be reached or used."""


class AwayError(FarmError):
    """The same of what may come back."""
