#!/usr/bin/env python3
"""Applies each recipe of docs/developer/how-to-add.md to a copy of the tree: the files that change, and their lines,
are those that the guide lists, and the code that the guide shows is the code that was applied.

usage: recipes_test.py SOURCE_FOLDER [--build]

  --build   all recipes on one copy: it is built in release, what is generated is generated, and the tests that the
            recipes and their surroundings have pass. Half an hour without a cache of the compiler.

With STANOK_WRITE_DOCS=1 the lists of files in the guide are written. STANOK_RECIPES_JOBS is the number of compilers.
"""
import difflib
import filecmp
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from guide import Guide  # noqa: E402
from recipe import RecipeFault  # noqa: E402

GUIDE = "docs/developer/how-to-add.md"
NAMES = ("kinematic_scheme", "feed_law", "g_code", "daemon_command", "machine_command", "axis_limit",
         "drive_sensor")
LEFT_OUT = {".git", "build", "out", "node_modules", "__pycache__"}  # without git
BAR_MAX = 40

# Test programs of what the recipes touch, and what of them runs.
TESTS = {"kinematics": "*", "lang": "*", "base": "*", "config": "*", "protocol": "*", "recording": "MessagesDocument.*",
         "drives": "*", "plant": "*", "motion": "AlternatingLaw.*:FeedLaw*",
         "channels": "OperatorCommand*:JogFrom.*:JogLimit.*:StraightJog*:SingleBlock*",
         "daemon": "*CommandTable*:DispatchTest.*:ChannelDisplay.*:Subscription.*",
         "layering": "*"}


def load_recipes():
    recipes = {}
    for name in NAMES:
        spec = importlib.util.spec_from_file_location(f"{name}_recipe", HERE / name / "recipe.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        recipes[name] = module.RECIPE
    return recipes


def tracked_files(root):
    """Those of git; without git, what lies there and is not built."""
    git = ["git", "-c", f"safe.directory={root}", "-C", str(root), "ls-files", "-z"]
    try:
        names = subprocess.run(git, capture_output=True, check=True, text=True).stdout.split("\0")
    except (OSError, subprocess.CalledProcessError):
        names = []
        for folder, folders, files in os.walk(root):
            folders[:] = [name for name in folders if name not in LEFT_OUT]
            names += [os.path.relpath(os.path.join(folder, name), root) for name in files]
    return sorted(name for name in names if name and (root / name).is_file())


class Tree:
    """A copy of the tracked files, compared with where it was taken from."""

    def __init__(self, root, folder):
        self.root = root
        self.folder = folder
        for name in tracked_files(root):
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / name, target, follow_symlinks=False)

    def differing(self):
        """Files that differ, and how many lines were added and removed in each."""
        return {name: self._lines(name) for name in tracked_files_of_copy(self.folder) if not self._same(name)}

    def restore(self):
        for name in self.differing():
            (self.folder / name).unlink()
            if (self.root / name).exists():
                shutil.copy2(self.root / name, self.folder / name, follow_symlinks=False)

    def _same(self, name):
        return (self.root / name).exists() and filecmp.cmp(self.root / name, self.folder / name)

    def _lines(self, name):
        old = (self.root / name).read_text(encoding="utf-8").splitlines() if (self.root / name).exists() else []
        new = (self.folder / name).read_text(encoding="utf-8").splitlines()
        marks = [line[0] for line in list(difflib.unified_diff(old, new, lineterm="", n=0))[2:] if line[0] in "+-"]
        return marks.count("+"), marks.count("-")


def tracked_files_of_copy(folder):
    names = []
    for place, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if name not in LEFT_OUT]
        names += [os.path.relpath(os.path.join(place, name), folder) for name in files]
    return sorted(names)


def listed(differing):
    """As `git diff --stat` lists them."""
    width = max(map(len, differing))
    most = max(sum(lines) for lines in differing.values())
    rows = []
    for name, (added, removed) in sorted(differing.items()):
        part = min(1.0, BAR_MAX / most)
        bar = "+" * (added and max(1, round(part * added))) + "-" * (removed and max(1, round(part * removed)))
        rows.append(f" {name:{width}} | {added + removed:{len(str(most))}} {bar}")
    return rows


def faults_of_list(guide, recipe, differing):
    """Against the list of the section; it is written instead where that is asked for."""
    block, files = guide.list_of_files(recipe.heading)
    counts = {name: sum(lines) for name, lines in differing.items()}
    if files == counts:
        return []
    if os.environ.get("STANOK_WRITE_DOCS") == "1":
        guide.lines[block.place - 1:block.place - 1 + len(block.lines)] = listed(differing)
        guide.path.write_text("\n".join(guide.lines), encoding="utf-8")
        return []
    return [f"{GUIDE}:{block.place}: the recipe '{recipe.heading}' changes these files:\n" +
            "\n".join(listed(differing))]


def faults_of_text(guide, recipe):
    """Every file of the list is one that the section names."""
    text = guide.text(recipe.heading)
    return [f"{GUIDE}: section '{recipe.heading}' does not say what changes in {name}"
            for name in recipe.files() if Path(name).stem not in text]


def parts_of(block):
    """Of a block of code: without the name of the file in front, and without the lines that it leaves out (...)."""
    lines = block.lines[1:] if re.fullmatch(r"// \S+\.\w+(, .*)?", block.lines[0]) else block.lines
    parts = [[]]
    for line in lines:
        if line.strip() == "...":
            parts.append([])
        else:
            parts[-1].append(line)
    return [part for part in parts if part]


def shows(path, parts):
    """Whether the file holds each of the parts without a gap."""
    if not path.exists():
        return False
    lines = path.read_text(encoding="utf-8").split("\n")
    return all(any(lines[k:k + len(part)] == part for k in range(len(lines))) for part in parts)


def faults_of_code(guide, recipe, tree):
    """What the section shows stands in a file that the recipe changes, and did not before."""
    faults = []
    for block in guide.code(recipe.heading):
        parts = parts_of(block)
        is_applied = any(shows(tree.folder / name, parts) and not shows(tree.root / name, parts)
                         for name in recipe.files())
        if not is_applied:
            faults.append(f"{GUIDE}:{block.place}: this is not what the recipe '{recipe.heading}' applies:\n" +
                          "\n".join(block.lines))
    return faults


def check_recipe(guide, recipe, tree):
    try:
        recipe.apply(tree.folder)
        return (faults_of_list(guide, recipe, tree.differing()) + faults_of_text(guide, recipe) +
                faults_of_code(guide, recipe, tree))
    except (RecipeFault, LookupError) as fault:
        return [f"recipe '{recipe.heading}': {fault}"]
    finally:
        tree.restore()


def apply_all(recipes, tree):
    for recipe in recipes.values():
        try:
            recipe.apply(tree.folder)
        except RecipeFault as fault:
            return [f"recipe '{recipe.heading}' after the others: {fault}"]
    return []


def check_each(guide, recipes, tree):
    faults = [fault for recipe in recipes.values() for fault in check_recipe(guide, recipe, tree)]
    faults += apply_all(recipes, tree) if not faults else []
    print("\n\n".join(faults) if faults else f"{len(recipes)} recipes change what the guide lists")
    return not faults


def runs(folder, *command):
    """In the environment of the project's scripts: compiler cache, locale."""
    print("$", " ".join(command), flush=True)
    script = 'source tools/environment.sh && exec "$@"'
    return subprocess.run(["bash", "-c", script, "bash", *command], cwd=folder, check=False).returncode == 0


def faults_of_generated(guide, tree, applied):
    changed = {name for name in tree.differing() if applied.get(name) != (tree.folder / name).read_bytes()}
    listed_there = guide.generated_files()
    return ([f"{GUIDE}: {name} is generated, and not listed" for name in sorted(changed - listed_there)] +
            [f"{GUIDE}: {name} is listed, and not generated" for name in sorted(listed_there - changed)])


def check_build(guide, recipes, tree):
    faults = apply_all(recipes, tree)
    if faults:
        print("\n".join(faults))
        return False
    applied = {name: (tree.folder / name).read_bytes() for name in tree.differing()}
    programs = [f"{name}_tests" for name in TESTS]
    jobs = os.environ.get("STANOK_RECIPES_JOBS", str(os.cpu_count()))
    steps = (("cmake", "--preset", "release"),
             ("ninja", "-C", "build/release", f"-j{jobs}", *programs, "stanok_python"),
             ("tools/generate.sh", "--no-page"))
    if not all(runs(tree.folder, *step) for step in steps):
        return False
    faults = faults_of_generated(guide, tree, applied)
    faults += [f"{name}_tests failed" for name, tests in TESTS.items() if not
               runs(tree.folder, f"build/release/tests/{name}_tests", "--gtest_brief=1", f"--gtest_filter={tests}")]
    print("\n".join(faults) if faults else f"{len(recipes)} recipes on one tree: built, generated, tested")
    return not faults


def main():
    root = Path(sys.argv[1]).resolve()
    guide = Guide(root / GUIDE)
    recipes = load_recipes()
    check = check_build if "--build" in sys.argv[2:] else check_each
    with tempfile.TemporaryDirectory(prefix="stanok-recipes-") as folder:
        good = check(guide, recipes, Tree(root, Path(folder)))
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
