"""Writes the man pages and the completions of the commands, from what each prints with --help.

That of tank_datum comes from the one table of options, so that nothing is said twice.
Usage: python command_pages.py FOLDER PROGRAM...     (PROGRAM: an executable, or "python -m module")
Makes FOLDER/man1/NAME.1, FOLDER/bash/NAME and FOLDER/zsh/_NAME.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

STATUS = {  # of the programs that read scans and results
    "0": "a usable result",
    "1": "the data hold none; the results say why",
    "2": "wrong use or a refused option",
    "3": "a file could not be read or written",
}
OTHERS = {"tank_datum_qa": {"0": "all within tolerance", "1": "a case failed", "2": "wrong use"}}
NO_FILE = {"INT", "FLOAT", "N", "WORD"}  # values that are no file


@dataclass
class Option:
    """One option as --help prints it."""

    flags: list[str]
    value: str = ""  # INT, TEXT, FILE; empty: none
    words: list[str] = field(default_factory=list)
    default: str = ""
    text: str = ""


@dataclass
class Program:
    """What --help says of a program."""

    name: str
    version: str
    about: str
    usage: str
    options: list[Option]


def said(words: list[str], *arguments: str) -> str:
    run = subprocess.run([*words, *arguments], capture_output=True, text=True, check=True)
    return run.stdout


def value_of(shown: str) -> tuple[str, list[str], str]:
    """TEXT:{a,b}=a as its kind, its words, its default."""
    found = re.match(r"^(\w+)(?::\{([^}]*)\})?(?:=(.*))?$", shown)
    if found is None:
        return shown, [], ""
    return found[1], found[2].split(",") if found[2] else [], found[3] or ""


def options_of(text: str) -> list[Option]:
    """The options in the text of --help, each with the lines below it."""
    options: list[Option] = []
    for line in text.partition("ptions:")[2].splitlines():
        if re.match(r"^ {2}-", line):
            head, _, help_text = line.strip().partition("  ")
            words = head.replace("{false}", "").split(" ")
            flags = words[0].rstrip(",").split(",")
            kind, choices, default = value_of(words[1] if len(words) > 1 else "")
            if kind.endswith(":"):  # "Excludes: --other"
                kind = ""
            options.append(Option(flags, kind, choices, default, help_text.strip()))
        elif options and line.startswith(" " * 20):
            options[-1].text = f"{options[-1].text} {line.strip()}".strip()
        elif options and line and not line.startswith(" "):
            break
    return options


def read(command: str) -> Program:
    words = shlex.split(command)
    name = Path(words[0]).name if "-m" not in words else words[words.index("-m") + 1]
    text = said(words, "--help")
    usage = re.search(r"^[Uu]sage: (.*(?:\n +.*)*)", text, re.M)
    if usage is None:
        raise SystemExit(f"command_pages: {name} --help, no line of usage, expected one")
    about = text.strip().splitlines()[0]
    if about.lower().startswith("usage:"):
        about = text[usage.end() :].strip().partition("\n\n")[0]
    version = "" if "-m" in words else said(words, "--version").split()[-1]
    return Program(name, version, about, " ".join(usage[1].split()), options_of(text))


def roff(text: str) -> str:
    """Text that roff takes for text."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return f"\\&{text}" if text[:1] in (".", "'") else text


def man_page(program: Program, others: list[str]) -> str:
    """The page of section 1."""
    name = program.name
    first = program.about.rstrip(".")
    lines = [f'.TH {name.upper()} 1 "" "{f"tank_datum {program.version}".strip()}" "User commands"']
    lines += [".SH NAME", f"{name} \\- {roff(first)}", ".SH SYNOPSIS", f"{roff(program.usage)}"]
    lines += [".SH DESCRIPTION", roff(program.about), ".SH OPTIONS"]
    for option in program.options:
        flags = ", ".join(f"\\fB{roff(flag)}\\fR" for flag in option.flags)
        value = "|".join(option.words) or option.value
        lines += [".TP", f"{flags} \\fI{roff(value)}\\fR" if value else flags]
        default = f" (default: {option.default})" if option.default else ""
        lines.append(roff(option.text + default) or "\\&")
    lines.append(".SH EXIT STATUS")
    for status, meaning in OTHERS.get(name, STATUS).items():
        lines += [".TP", status, roff(meaning)]
    also = ", ".join(f"\\fB{roff(other)}\\fR(1)" for other in others if other != name)
    return "\n".join([*lines, ".SH SEE ALSO", also, ""])


def bash_completion(program: Program) -> str:
    """Flags, words of choices, and files."""
    flags = " ".join(flag for option in program.options for flag in option.flags)
    cases = []
    for option in program.options:
        names = "|".join(option.flags)
        if option.words:
            words = " ".join(option.words)
            cases.append(f'    {names}) COMPREPLY=($(compgen -W "{words}" -- "$word")); return ;;')
        elif option.value in NO_FILE:
            cases.append(f"    {names}) return ;;")
    listed = "\n".join(cases)
    body = f'  case "$before" in\n{listed}\n  esac\n' if cases else ""
    return (
        f"# bash completion of {program.name}\n_{program.name}() {{\n"
        '  local word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}"\n'
        f"  COMPREPLY=()\n{body}"
        f'  if [[ $word == -* ]]; then COMPREPLY=($(compgen -W "{flags}" -- "$word")); return; fi\n'
        '  COMPREPLY=($(compgen -f -- "$word"))\n'
        f"}}\ncomplete -o filenames -F _{program.name} {program.name}\n"
    )


def zsh_completion(program: Program) -> str:
    """The same for zsh, with the meaning of each flag."""
    lines = []
    for option in program.options:
        meaning = re.sub(r"[\[\]:'`\\$]", " ", option.text)
        action = ""
        if option.words:
            action = f":value:({' '.join(option.words)})"
        elif option.value:
            action = ":value:" if option.value in NO_FILE else ":file:_files"
        lines += [f"  '{flag}[{meaning}]{action}' \\" for flag in option.flags]
    return "\n".join([f"#compdef {program.name}", "_arguments \\", *lines, "  '*:file:_files'", ""])


def main() -> None:
    folder, programs = Path(sys.argv[1]), [read(command) for command in sys.argv[2:]]
    names = [program.name for program in programs]
    for kind in ("man1", "bash", "zsh"):
        (folder / kind).mkdir(parents=True, exist_ok=True)
    for program in programs:
        (folder / "man1" / f"{program.name}.1").write_text(man_page(program, names))
        (folder / "bash" / program.name).write_text(bash_completion(program))
        (folder / "zsh" / f"_{program.name}").write_text(zsh_completion(program))


if __name__ == "__main__":
    main()
