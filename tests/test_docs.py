# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages: every link and picture is there, every page can be reached, every command has one, names in them exist."""

import ast
import fnmatch
import re
import shlex
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from freecad_trabecula.core.analysis.tables import BRANCH_COLUMNS, CONTOUR_COLUMNS, PROFILE_COLUMNS
from freecad_trabecula.gui import help_pages
from freecad_trabecula.shell.arguments import read_arguments

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.rglob("*.md")])
COMMANDS = DOCS / "commands"
#: Rows of the table in the page of a command.
ROWS = ("needs", "makes", "undo", "script", "shell")
_LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def without_code(text):
    """Return a page without its blocks of code, where brackets mean something else."""
    return re.sub(r"```.*?```", "", text, flags=re.DOTALL)


def links_of(page):
    """Return (is a picture, target) of the links of a page, those to other sites left out."""
    found = _LINK.findall(without_code(page.read_text(encoding="utf-8")))
    return [(bool(mark), target) for mark, _, target in found if "://" not in target]


def anchors_of(page):
    """Return the headings of a page as links name them."""
    return {help_pages.slug(heading) for heading, _ in help_pages.passages_of(page.read_text(encoding="utf-8"))}


def dead_links(page):
    """Return the links of a page that lead nowhere."""
    dead = []
    for _, target in links_of(page):
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve() if name else page
        if not path.exists() or (anchor and anchor not in anchors_of(path)):
            dead.append(target)
    return dead


def named(path):
    return path.relative_to(ROOT).as_posix()


def test_every_link_and_every_picture_is_there():
    assert len(PAGES) > 30
    assert {named(page): dead_links(page) for page in PAGES if dead_links(page)} == {}


def test_dead_links_and_headings_that_are_missing_are_found(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "# One\n[a](nowhere.md) [b](#one) [c](#two) ![d](no.png)\n```\n[e](code.md)\n```\n", encoding="utf-8"
    )
    assert dead_links(page) == ["nowhere.md", "#two", "no.png"]


def test_every_page_can_be_reached_from_the_table_of_contents():
    reached, waiting = set(), [DOCS / "README.md"]
    while waiting:
        page = waiting.pop()
        if page not in reached:
            reached.add(page)
            targets = [(page.parent / target.partition("#")[0]).resolve() for _, target in links_of(page)]
            waiting += [target for target in targets if target.suffix == ".md"]
    assert [named(page) for page in PAGES if page not in reached] == []


def test_every_picture_is_shown_by_a_page():
    shown = {(page.parent / target).resolve() for page in PAGES for is_picture, target in links_of(page) if is_picture}
    assert [named(path) for path in sorted((DOCS / "pictures").iterdir()) if path not in shown] == []


def makers_of_pictures():
    """Return the table of docs/README.md: (pattern, command) of each kind of picture."""
    text = (DOCS / "README.md").read_text(encoding="utf-8").partition("## The pictures")[2].partition("\n## ")[0]
    rows = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| `")]
    return [(pattern, made) for names, made in rows for pattern in re.findall(r"`([^`]+)`", names)]


def tool_of(command):
    """Return the file that the first command of a row starts: ``make gallery`` is tools/gallery.py."""
    first = re.search(r"`([^`]+)`", command)[1].split()
    return ROOT / (first[1] if first[0] == "python3" else f"tools/{first[1]}.py")


def test_every_picture_is_made_by_one_command_that_names_it():
    rows = makers_of_pictures()
    pictures = sorted(path.stem for path in (DOCS / "pictures").iterdir())
    makers = {name: [made for pattern, made in rows if fnmatch.fnmatchcase(name, pattern)] for name in pictures}
    assert {name: found for name, found in makers.items() if len(found) != 1} == {}
    assert [pattern for pattern, _ in rows if not fnmatch.filter(pictures, pattern)] == []
    source = {made: tool_of(made).read_text(encoding="utf-8") for _, made in rows}
    walked = re.compile(r"tour-(rods|measure|voxels)-")  # named by their doors and steps
    unnamed = [
        name
        for name, found in makers.items()
        if not (f'"{name}' in source[found[0]] or (walked.match(name) and 'f"tour-{door}-' in source[found[0]]))
    ]
    assert unnamed == []


def test_every_picture_of_the_gallery_is_taken_by_a_part_that_its_row_names():
    window = (ROOT / "tools" / "gallery_window.py").read_text(encoding="utf-8")
    parts = dict(re.findall(r"(\w+)=take_(\w+)", window), panels="panels", analysis="analysis", voxels="voxels")
    for _, made in makers_of_pictures():
        if "make gallery" in made:
            for part in re.search(r"--only ([\w ]+)", made)[1].split():
                assert part in parts or part in ("case6", "cranial"), made


def command_names():
    """Return the names of all commands that the window's modules register."""
    found = set()
    for path in (ROOT / "freecad_trabecula" / "gui").glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                found.update(re.findall(r"^Trabecula_[A-Z]\w*[a-z0-9]$", node.value))
    return sorted(found)


def test_every_command_has_a_page_which_the_list_of_commands_names():
    names = command_names()
    assert len(names) > 20
    assert [name for name in names if not (DOCS / help_pages.page_of_command(name)).is_file()] == []
    listed = {target for _, target in links_of(COMMANDS / "README.md")}
    assert [path.name for path in COMMANDS.glob("*.md") if path.name not in (*listed, "README.md")] == []


def test_the_pages_to_which_panels_and_docks_lead_are_there():
    texts = {path: path.read_text(encoding="utf-8") for path in (ROOT / "freecad_trabecula" / "gui").glob("*.py")}
    named_pages = {page for text in texts.values() for page in re.findall(r"\"((?:commands/)?[\w-]+\.md)\"", text)}
    assert len(named_pages) > 8
    assert [page for page in sorted(named_pages - {"search.md"}) if not (DOCS / page).is_file()] == []
    docks = [path.name for path, text in texts.items() if "(QtGui.QDockWidget)" in text or "(ObjectDock)" in text]
    bare = {"help_dock.py", "object_dock.py", "task_dock.py"}  # the help itself, the base of two, FreeCAD's own
    assert [
        name
        for name in docks
        if name not in bare and "help_buttons(" not in texts[ROOT / "freecad_trabecula" / "gui" / name]
    ] == []


def script_names():
    """Return the functions of ``make``."""
    for node in ast.parse((ROOT / "freecad_trabecula" / "make.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return set(ast.literal_eval(node.value))
    raise AssertionError("make has no __all__")


def flags_of_the_shell():
    """Return all options of the command line."""
    folder = ROOT / "freecad_trabecula" / "shell"
    texts = [path.read_text(encoding="utf-8") for path in folder.glob("*.py")]
    return {flag for text in texts for flag in re.findall(r"\"(--[a-z][\w-]*)\"", text)} | {"--help"}


@pytest.mark.parametrize("page", sorted(COMMANDS.glob("[A-Z]*.md")), ids=lambda page: page.stem)
def test_the_page_of_a_command_says_all_there_is_to_say(page):
    if page.stem == "README":
        return
    text = page.read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| (\w+) \| (.+) \|$", text, re.MULTILINE))
    assert [row for row in ROWS if len(rows.get(row, "")) < 1] == []
    assert f"| | `Trabecula_{page.stem}` |" in text
    assert set(re.findall(r"make\.(\w+)", rows["script"])) <= script_names()
    assert set(re.findall(r"--[a-z][\w-]*", rows["shell"])) <= flags_of_the_shell()
    assert "(../../resources/icons/" in text


def shell_lines(page):
    """Return the words of the commands of ours in a page's blocks of code."""
    blocks = re.findall(r"```sh\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    lines = [line.partition(" #")[0] for block in blocks for line in block.splitlines()]
    return [shlex.split(line)[3:] for line in lines if line.startswith("python3 -m freecad_trabecula")]


def test_every_line_for_the_shell_is_one_that_the_shell_takes():
    lines = [words for page in PAGES for words in shell_lines(page)]
    assert len(lines) > 8
    for words in lines:
        command, _ = read_arguments(words)  # wrong words end it with exit code 2
        assert command.name == words[0]


@pytest.mark.parametrize("page, folder", [("analysis.md", "core/analysis"), ("voxels.md", "core/voxels")])
def test_the_table_of_modules_has_all_of_them_and_no_other(page, folder):
    passage = (DOCS / page).read_text(encoding="utf-8").partition("## Modules")[2].partition("\n## ")[0]
    modules = (ROOT / "freecad_trabecula" / folder).glob("[a-z]*.py")
    assert sorted(set(re.findall(r"`(\w+\.py)`", passage))) == sorted(path.name for path in modules)


_PLACES = re.compile(r"(core|geometry|features|gui|shell|tests|tools|resources|docs)/[\w./-]+")


def is_there(code):
    """Return whether what a page names in code is there: a rule of make, a tool and its options, a function, a file."""
    words = code.split()
    tool = next((ROOT / word for word in words if word.startswith("tools/")), None)
    if words[0] == "make" and len(words) > 1:
        rules = re.findall(r"^([\w -]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
        return words[1].replace("-latest", "") in " ".join(rules).split()
    if words[0] in ("sh", "python3") and tool:
        text = tool.read_text(encoding="utf-8") if tool.is_file() else ""
        return bool(text) and all(flag in text for flag in re.findall(r"--[a-z][\w-]*", code))
    if _PLACES.fullmatch(code):
        return any((base / code).exists() for base in (ROOT, ROOT / "freecad_trabecula"))
    return set(re.findall(r"\bmake\.(\w+)", code)) <= {*script_names(), "py"}


def faults_of_code(text):
    """Return what a page names in code and is not there."""
    return [code for code in re.findall(r"`([^`\n]+)`", without_code(text)) if not is_there(code)]


def test_rules_tools_functions_and_files_that_pages_name_are_there():
    faults = {named(page): faults_of_code(page.read_text(encoding="utf-8")) for page in PAGES}
    assert {page: found for page, found in faults.items() if found} == {}


def test_what_a_page_names_and_what_is_not_there_is_found():
    right = "`make test-latest` `python3 tools/stalls.py --only` `make.make_box()` `core/strips.py` `docs/job.md`"
    assert faults_of_code(right) == []
    wrong = ["make nothing", "sh tools/none.sh", "python3 tools/stalls.py --none", "make.make_none()", "tests/none.py"]
    assert faults_of_code(" ".join(f"`{code}`" for code in wrong)) == wrong


@pytest.mark.parametrize("language, column", [("it", 2), ("de", 3)])
def test_the_glossary_has_the_words_of_the_translations(language, column):
    text = (DOCS / "glossary.md").read_text(encoding="utf-8").partition("## Measures")[0]
    rows = {
        cells[0]: cells for cells in re.findall(r"^\| \*(.+?)\* \| (.+?) \| (.+?) \| (.+?) \|$", text, re.MULTILINE)
    }
    path = ROOT / "resources" / "translations" / f"Trabecula_{language}.ts"
    shown = {
        one.findtext("source"): one.findtext("translation") for one in ElementTree.parse(str(path)).iter("message")
    }
    seen = 0
    for word, cells in rows.items():
        for source in (word, word.capitalize()):
            if source.lower() != "trabecula" and shown.get(source):  # our name too
                seen += 1
                assert shown[source].lower() == cells[column].lower(), word
    assert seen >= 10


@pytest.mark.parametrize("language, column", [("it", 2), ("de", 3)])
def test_the_glossary_of_a_language_has_the_words_of_the_english_one(language, column):
    def cells(page):
        rows = [line.strip("|").split("|") for line in (DOCS / page).read_text(encoding="utf-8").splitlines()]
        return [[cell.strip(" *") for cell in row] for row in rows if len(row) in (3, 4)]

    english, own = cells("glossary.md"), cells(f"glossary.{language}.md")
    words = [row for row in english if len(row) == 4 and row[0] not in ("word", "---")]
    assert len(words) > 35
    assert [(row[column], row[0]) for row in words] == [
        (row[0], row[2]) for row in own if len(row) == 4 and row[2] not in ("Englisch", "inglese", "---")
    ]
    signs = [row[0] for row in english if len(row) == 3 and "." in row[0]]
    assert [row[0] for row in own if len(row) == 3 and "." in row[0]] == signs


def test_the_columns_in_the_page_of_files_are_those_that_are_written():
    rows = dict(
        re.findall(r"^\| `(\w+)_x\.csv` \.\.\. \| (.+) \|$", (DOCS / "files.md").read_text("utf-8"), re.MULTILINE)
    )
    for name, columns in (("profile", PROFILE_COLUMNS), ("contours", CONTOUR_COLUMNS), ("branches", BRANCH_COLUMNS)):
        quoted = [word for part in re.findall(r"`([^`]+)`", rows[name]) for word in part.split(",")]
        assert sorted(quoted) == sorted(columns), name


def test_the_readme_is_short():
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= 90


def test_a_search_finds_a_page_by_its_heading_first_and_its_passages_whole():
    hits = help_pages.find("glossary")
    assert (hits[0].page, hits[0].text) == ("glossary.md", "Glossary")
    assert any(
        hit.page == "glossary.md" and "envelope less channels" in hit.text for hit in help_pages.find("scaffold")
    )
    assert help_pages.find("  ") == []
    assert help_pages.find("no such word in any page, surely") == []


def test_lines_of_a_paragraph_belong_together_and_code_holds_no_headings():
    text = "# One\nfirst line\nsecond line\n\n```\n# a comment\n```\n## Two\n* a point\n* another\n"
    assert list(help_pages.passages_of(text)) == [
        *(("One", "One"), ("One", "first line second line"), ("One", "# a comment")),
        *(("Two", "Two"), ("Two", "* a point"), ("Two", "* another")),
    ]


def test_what_a_search_found_leads_to_headings_that_exist():
    page = help_pages.page_of_hits("porosity", "Search", "Nothing")
    targets = [target for _, _, target in _LINK.findall(page)]
    assert 5 < len(targets) <= help_pages.MOST_HITS
    for target in targets:
        name, _, anchor = target.partition("#")
        assert anchor in anchors_of(DOCS / name), target
    assert help_pages.page_of_hits("no such word", "Search", "Nothing").endswith("Nothing")
