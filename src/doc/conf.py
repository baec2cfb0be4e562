"""Sphinx's settings. scripts/documentation.py lays the pages out and runs it; see there."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

project = "tank_datum"
author = "The authors of tank_datum"
copyright = author
release = version = re.search(r"project\(tank_datum VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc"]
root_doc = "README"
# Headings that other pages link to are those of the page as it stands in the repository.
myst_heading_anchors = 4
myst_links_external_new_tab = True

# The Python package without its compiled part: docstrings need no build.
sys.path.insert(0, str(ROOT / "src/python"))
autodoc_mock_imports = ["tank_datum._core"]
autodoc_member_order = "bysource"
autodoc_typehints = "description"
add_module_names = False
toc_object_entries_show_parents = "hide"

breathe_projects = {"tank_datum": str(ROOT / "build/docs/doxygen/xml")}
breathe_default_project = "tank_datum"
breathe_default_members = ("members", "undoc-members")
# The namespace is declared in every header.
suppress_warnings = ["duplicate_declaration.cpp"]
breathe_domain_by_extension = {"h": "cpp", "hpp": "cpp"}

html_theme = "furo"
html_title = f"tank_datum {release}"
html_show_sphinx = False
html_copy_source = False
html_static_path = ["style"]
html_css_files = ["wide.css"]


def without_options(app, what, name, obj, options, lines):  # noqa: ANN001, ANN201
    """The compiled part lists the options in a docstring; the pages have a table of their own."""
    stripped = [line.strip() for line in lines]
    if name == "tank_datum.extract_datum" and "Options:" in stripped:
        del lines[stripped.index("Options:") :]
        lines += ["", "The options are in the :doc:`table of options </src/doc/options>`.", ""]


def setup(app):  # noqa: ANN001, ANN201
    app.connect("autodoc-process-docstring", without_options)
