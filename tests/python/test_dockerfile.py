"""scripts/Dockerfile, as far as it can be checked without a Docker daemon."""

from __future__ import annotations

import re

from conftest import ROOT

TEXT = (ROOT / "scripts/Dockerfile").read_text().replace("\\\n", " ")


def test_packages_are_those_that_the_scripts_install() -> None:
    """Every package that a build without tests and viewer needs, by the name of setup.sh."""
    setup = (ROOT / "scripts/setup.sh").read_text().replace("\\\n", " ")
    configure = re.search(r"apt_install (g\+\+ .*)", setup)
    image = re.search(r"install -y --no-install-recommends (g\+\+ .*)", TEXT)
    assert configure is not None and image is not None
    not_needed = {"libgtest-dev", "locales", "python3", "libvtk9-dev", "libx11-dev"}
    of_cpack = {"dpkg-dev", "file"}
    assert set(image[1].split()) - of_cpack == set(configure[1].split()) - not_needed


def test_what_it_copies_is_there_and_all_that_the_build_needs() -> None:
    copied = {
        name
        for line in re.findall(r"^COPY (?!--from)(.*)", TEXT, re.MULTILINE)
        for name in line.split()[:-1]
    }
    assert all((ROOT / name).exists() for name in copied)
    named = re.findall(r"add_subdirectory\((\w+)", (ROOT / "CMakeLists.txt").read_text())
    assert {"CMakeLists.txt", "LICENSE", "include", *named} - {"tests"} <= copied


def test_the_command_is_what_it_runs() -> None:
    assert TEXT.rstrip().endswith('ENTRYPOINT ["tank_datum"]')
