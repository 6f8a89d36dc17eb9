"""What happens in a run, and when."""

from typing import Any

Event = tuple[float, str]


class Events:
    """Things that happened, each with its time [s]; they go to the file and to the result.

    Attributes:
        all: those noted so far.
        outcome: what became of the run in two words, for a run that cannot be called complete; else empty.
    """

    def __init__(self) -> None:
        self.all: list[Event] = []
        self.outcome = ""
        self._told = 0

    def note(self, time: float, text: str) -> None:
        """Keep that ``text`` happened at ``time`` [s]."""
        self.all.append((time, text))

    def take_new(self) -> list[Event]:
        """Those noted since the last call."""
        new, self._told = self.all[self._told :], len(self.all)
        return new

    def memory(self) -> dict[str, Any]:
        return {"all": list(self.all), "told": self._told, "outcome": self.outcome}

    def restore(self, memory: dict[str, Any]) -> None:
        self.all, self._told = [(float(time), str(text)) for time, text in memory["all"]], int(memory["told"])
        self.outcome = str(memory["outcome"])
