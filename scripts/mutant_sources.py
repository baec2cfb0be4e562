"""The named numbers of the library, and a copy of its sources that reads them when it starts.

In the copy `constexpr double kX = 0.5;` becomes a constant whose initialiser asks mutated.h for its
value, so that one build serves every mutant: TANK_DATUM_MUTANT="<key> <factor>" scales one constant
in a process. TANK_DATUM_TOUCHED names a file that gets the keys of the constants asked for.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

TYPES = r"double|float|int|std::size_t|std::ptrdiff_t|std::u?int\d+_t|Eigen::Index"
DECLARATION = re.compile(
    r"^(?P<indent>[ \t]*)(?P<storage>(?:static |inline )*)constexpr "
    rf"(?P<type>{TYPES})\s+(?P<rest>k\w+\s*=[^;]*);",
    re.MULTILINE,
)
STRUCTURES = re.compile(
    r"^(?P<indent>[ \t]*)constexpr (?P<type>[A-Z]\w*) (?P<rest>k\w+\{[^;]*\});", re.MULTILINE
)
ONE = re.compile(r"\s*(?P<name>k\w+)\s*=\s*(?P<value>.*)", re.DOTALL)
NUMBER = re.compile(r"(?<![\w\"'.])\d[\d']*(?:\.\d*)?(?:[eE][+-]?\d+)?[fFuUlL]*(?![\w\"'.])")
INTEGER = re.compile(r"-?\d[\d']*[uUlL]*")

HEADER = """#pragma once
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>
#include <string>

namespace mutants {

class Run {
 public:
  static Run& get() {
    static Run run;
    return run;
  }
  ~Run() {
    if (const char* path = std::getenv("TANK_DATUM_TOUCHED")) {
      std::ofstream file(path);
      for (const std::string& key : touched_) file << key << '\\n';
    }
  }
  double factorOf(const char* key) {
    const std::lock_guard<std::mutex> lock(mutex_);
    touched_.insert(key);
    return key_ == key ? factor_ : 1.0;
  }

 private:
  Run() {
    if (const char* mutant = std::getenv("TANK_DATUM_MUTANT")) {
      const std::string text(mutant);
      key_ = text.substr(0, text.find(' '));
      factor_ = std::stod(text.substr(text.find(' ') + 1));
    }
  }
  std::string key_;
  double factor_ = 1.0;
  std::mutex mutex_;
  std::set<std::string> touched_;
};

template <typename Value>
Value value(const char* key, Value as_written) {
  const double factor = Run::get().factorOf(key);
  return factor == 1.0 ? as_written : static_cast<Value>(static_cast<double>(as_written) * factor);
}

}  // namespace mutants
"""


@dataclass(frozen=True)
class Constant:
    """One named number of one file."""

    path: str
    line: int
    name: str
    value: str

    @property
    def key(self) -> str:
        return f"{self.path}:{self.name}"

    def factors(self) -> list[float]:
        """0.5 and 2, without those that leave the number as it is or make 0 of a count."""
        if not INTEGER.fullmatch(self.value):
            return [] if self.value in ("0.0", "-0.0") else [0.5, 2.0]
        number = int(self.value.rstrip("uUlL").replace("'", ""))
        return [f for f in (0.5, 2.0) if int(number * f) not in (0, number)]


def parts(text: str) -> list[str]:
    """The text cut at its commas, but not at those in brackets."""
    found, depth = [""], 0
    for letter in text:
        depth += (letter in "({[") - (letter in ")}]")
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return found


def without_comments(text: str) -> str:
    return re.sub(r"//[^\n]*", "", text)


class Rewriter:
    """Finds the constants of one source file and writes the file anew."""

    def __init__(self, path: str, text: str, compile_time: frozenset[str] = frozenset()) -> None:
        self.path, self.text, self.compile_time = path, text, compile_time
        self.constants: list[Constant] = []
        self.is_changed = False
        self._seen: dict[str, int] = {}
        found = sorted(
            [*DECLARATION.finditer(text), *STRUCTURES.finditer(text)],
            key=lambda match: match.start(),
        )
        pieces, done = [], 0
        for match in found:
            pieces += [text[done : match.start()], self._rewritten(match)]
            done = match.end()
        body = "".join([*pieces, text[done:]])
        self.rewritten = f'#include "mutated.h"\n{body}' if self.is_changed else text

    def _constant(self, match: re.Match[str], name: str, value: str) -> Constant:
        """Known by its path and name; the second of that name in a file is name#2."""
        self._seen[name] = self._seen.get(name, 0) + 1
        if self._seen[name] > 1:
            name = f"{name}#{self._seen[name]}"
        line = self.text.count("\n", 0, match.start()) + 1
        constant = Constant(self.path, line, name, " ".join(value.split()))
        self.constants.append(constant)
        return constant

    def _rewritten(self, match: re.Match[str]) -> str:
        if match.re is STRUCTURES:
            return self._structures(match)
        declared = [ONE.fullmatch(part) for part in parts(without_comments(match["rest"]))]
        if None in declared:  # a name without k among them
            return match[0]
        return "\n".join(self._number(match, d["name"], d["value"].strip()) for d in declared)

    def _number(self, match: re.Match[str], name: str, value: str) -> str:
        """The declaration of one constant; what follows from others is no longer constexpr."""
        indent, storage, kind = match["indent"], match["storage"], match["type"]
        as_it_was = f"{indent}{storage}constexpr {kind} {name} = {value};"
        if "numeric_limits" in value or "sizeof" in value or "0x" in value:
            return as_it_was
        asked = value
        if NUMBER.search(value):
            constant = self._constant(match, name, value)
            if constant.key in self.compile_time:
                return as_it_was
            asked = f'::mutants::value<{kind}>("{constant.key}", {value})'
        self.is_changed = True
        if not indent:  # of a namespace: a function, asked for by those who use it only
            body = f"{{ static const {kind} value = {asked}; return value; }}"
            return f"inline {kind} {name}_mutated() {body}\n#define {name} {name}_mutated()"
        inline = "inline " if storage else ""  # of a class
        return f"{indent}static {inline}const {kind} {name} = {asked};"

    def _structures(self, match: re.Match[str]) -> str:
        """Structures of numbers; each number is a constant of its own, kX.1, kX.2."""
        self.is_changed = True
        done = []
        for part in parts(without_comments(match["rest"])):
            name, fields = part.strip().rstrip("}").split("{", 1)
            asked = []
            for field in map(str.strip, parts(fields)):
                if NUMBER.search(field) and not field.startswith('"'):
                    constant = self._constant(match, f"{name}.{len(asked) + 1}", field)
                    field = f'::mutants::value<double>("{constant.key}", {field})'
                asked.append(field)
            done.append(f"{name}{{{', '.join(asked)}}}")
        return f"{match['indent']}static const {match['type']} {', '.join(done)};"


def library_files(root: Path) -> list[Path]:
    """The sources and headers of the library, without those of the Python module."""
    files = [
        path
        for folder in ("src", "include")
        for path in (root / folder).rglob("*")
        if path.suffix in (".cpp", ".h", ".hpp") and "python" not in path.parts
    ]
    return sorted(files)


def all_constants(root: Path) -> list[Constant]:
    return [
        constant
        for path in library_files(root)
        for constant in Rewriter(str(path.relative_to(root)), path.read_text()).constants
    ]


def write_copy(root: Path, copy: Path, compile_time: frozenset[str]) -> None:
    """The checkout at `copy`, its constants read at start; only files that change are written."""
    library = set(library_files(root))
    written = set()
    for folder in ("src", "include", "apps", "tests", "scripts"):
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                content = path.read_bytes()
                if path in library:
                    key = str(path.relative_to(root))
                    content = Rewriter(key, content.decode(), compile_time).rewritten.encode()
                written.add(put(copy / path.relative_to(root), content))
    for name in ("CMakeLists.txt", "LICENSE", "README.md"):
        written.add(put(copy / name, (root / name).read_bytes()))
    written.add(put(copy / "include/mutated.h", HEADER.encode()))
    for folder in ("src", "include", "apps", "tests"):
        for path in (copy / folder).rglob("*"):
            if path.is_file() and path not in written:
                path.unlink()


def put(path: Path, content: bytes) -> Path:
    if not path.is_file() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return path
