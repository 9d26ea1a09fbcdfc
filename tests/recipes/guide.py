"""docs/developer/how-to-add.md as a reader sees it: sections, the code that they show, the files that they list."""
import re
from dataclasses import dataclass

FENCE = re.compile(r"^ *```(\w*)$")
LISTED = re.compile(r"^ (\S+) +\| +(\d+) [+-]+$")


@dataclass(frozen=True)
class Block:
    language: str
    lines: list[str]
    place: int  # of its first line in the guide, from 1


class Guide:
    def __init__(self, path):
        self.path = path
        self.lines = path.read_text(encoding="utf-8").split("\n")

    def section(self, heading):
        """First and last line of a section, from 0; subsections that follow belong to it."""
        starts = [k for k, line in enumerate(self.lines) if re.fullmatch(rf"#+ {re.escape(heading)}", line)]
        if len(starts) != 1:
            raise LookupError(f"{len(starts)} headings '{heading}'")
        level = len(self.lines[starts[0]].split(" ", 1)[0])
        ends = re.compile(rf"#{{1,{level}}} ")
        for k in range(starts[0] + 1, len(self.lines)):
            if ends.match(self.lines[k]) and not self._in_code(k):
                return starts[0], k - 1
        return starts[0], len(self.lines) - 1

    def _in_code(self, line):
        return sum(1 for one in self.lines[:line] if FENCE.match(one)) % 2 == 1

    def blocks(self, heading):
        """Blocks of code, without their indentation in the document."""
        first, last = self.section(heading)
        found = []
        start = None
        for k in range(first, last + 1):
            match = FENCE.match(self.lines[k])
            if match is None:
                continue
            if start is None:
                start, language, indent = k + 1, match[1], len(self.lines[k]) - len(self.lines[k].lstrip())
            else:
                found.append(Block(language, [line[indent:] for line in self.lines[start:k]], start + 1))
                start = None
        return found

    def list_of_files(self, heading):
        """The block that lists the files of a recipe, as `git diff --stat` does, and its files with their lines."""
        lists = [block for block in self.blocks(heading) if block.lines and all(map(LISTED.match, block.lines))]
        if len(lists) != 1:
            raise LookupError(f"section '{heading}' has {len(lists)} lists of files")
        return lists[0], {match[1]: int(match[2]) for match in map(LISTED.match, lists[0].lines)}

    def code(self, heading):
        return [block for block in self.blocks(heading) if block.language]

    def text(self, heading):
        """Without the list of files."""
        first, last = self.section(heading)
        return "\n".join(line for line in self.lines[first:last + 1] if not LISTED.match(line))

    def generated_files(self):
        """The files in the first column of the table of what is generated, by the texts of their links."""
        first, last = self.section("What is generated")
        columns = [line.split("|")[1] for line in self.lines[first:last + 1] if line.startswith("| [")]
        return {name for column in columns for name in re.findall(r"\[([^\]]+)\]\(", column)}
