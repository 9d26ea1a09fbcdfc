"""What a recipe of docs/developer/how-to-add.md changes, as data: lines at anchors, and new files.

An anchor is one line or several, whole and with their indentation, that stand exactly once in the file. Texts may be
written as blocks: one line break at the start and one at the end are not part of them.
"""
from dataclasses import dataclass
from pathlib import Path


class RecipeFault(Exception):
    """A recipe no longer fits the tree: file and anchor."""


@dataclass(frozen=True)
class Change:
    """The lines that come before, in place of and after an anchor; without an anchor, a new file."""

    file: str
    anchor: str | None
    text: str
    whole_lines: bool = True


def _lines(text):
    return text.removeprefix("\n").removesuffix("\n")


def new_file(file, kept_in):
    """A file that stands beside the recipe, in the folder `kept_in`, under its own name."""
    return Change(file, None, (Path(kept_in) / Path(file).name).read_text(encoding="utf-8"))


def after(file, anchor, text):
    return Change(file, _lines(anchor), f"{_lines(anchor)}\n{_lines(text)}")


def before(file, anchor, text):
    return Change(file, _lines(anchor), f"{_lines(text)}\n{_lines(anchor)}")


def replaced(file, anchor, text):
    return Change(file, _lines(anchor), _lines(text))


def words_replaced(file, anchor, text):
    """Within a line."""
    return Change(file, anchor, text, whole_lines=False)


@dataclass(frozen=True)
class Recipe:
    heading: str  # of its section in the guide
    changes: list[Change]

    def files(self):
        return {change.file for change in self.changes}

    def apply(self, tree):
        """Changes the files of `tree`, or raises a RecipeFault."""
        for change in self.changes:
            path = tree / change.file
            if change.anchor is None:
                if path.exists():
                    raise RecipeFault(f"{change.file} exists: the recipe adds what is there already")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(change.text, encoding="utf-8")
            else:
                path.write_text(_changed(path, change), encoding="utf-8")


def _changed(path, change):
    if not path.exists():
        raise RecipeFault(f"{change.file} does not exist")
    content = "\n" + path.read_text(encoding="utf-8")
    end = "\n" if change.whole_lines else ""
    anchor = f"{end}{change.anchor}{end}"
    found = content.count(anchor)
    if found != 1:
        raise RecipeFault(f"{change.file}: this anchor stands there {found} times, not once:\n{change.anchor}")
    return content.replace(anchor, f"{end}{change.text}{end}").removeprefix("\n")
