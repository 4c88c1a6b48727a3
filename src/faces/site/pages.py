"""pages.py SOURCES BUILD OUT: makes OUT/pages of the project's Markdown, with navigation and a search that needs no server.

The pages stay where they are in the repository: links between them are those that editors and forges follow. What a page
leads to becomes a page, too: a folder its list of files, a text its lines. The command line's page is what the program
says of itself. MkDocs and its theme Material are Debian's; the theme's search asks a server for its index and its worker,
so both are carried as a script.
"""
import html
import json
import os
import posixpath
import re
import shutil
import subprocess
import sys
import unicodedata

import yaml
from mkdocs.commands.build import build
from mkdocs.config import load_config

HERE = os.path.dirname(os.path.abspath(__file__))
SHOWN = {".toml": "toml", ".py": "python", ".csv": "text", ".hpp": "cpp", ".cpp": "cpp", ".h": "c", ".c": "c", ".txt": "text",
         ".json": "json", ".jsonl": "text", ".theorems": "text", ".mjs": "javascript", ".ipynb": "json", "": "text"}
COMMAND_LINE, GLOSSARY = "COMMAND_LINE.md", "proofs/GLOSSARY.md"
LARGEST = 200_000  # bytes of a text that is shown; a longer one is a file to open
LINK = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(?=[)\s])")


def slug(text, separator="-"):
    """What a heading is called in links, by the rule of the test of the pages' links."""
    return re.sub(r"""[][`*.,:;!?()"<>=|/\\$^&'+]""", "", html.unescape(text).lower()).replace(" ", separator)


class Pages:
    """A folder of Markdown that MkDocs reads."""

    def __init__(self, sources, folder):
        self.sources, self.folder = sources, folder
        self.waiting, self.made = [], set()

    def read(self, path):
        with open(os.path.join(self.sources, path), encoding="utf-8") as file:
            return file.read()

    def write(self, path, text):
        target = os.path.join(self.folder, path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, "w", encoding="utf-8") as file:
            file.write(text)

    def add(self, path, text):
        """A page, and what it leads to."""
        self.made.add(path)
        beside = posixpath.dirname(path)

        def leads(match):
            start, target, part = match.groups()
            if re.match(r"[a-z]+:", target):
                return match[0]
            found = self.leads_to(posixpath.normpath(posixpath.join(beside, target)))
            return start + posixpath.relpath(found, beside or ".") + (part or "")

        blocks = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
        self.write(path, "".join(b if i % 2 else LINK.sub(leads, b) for i, b in enumerate(blocks)))

    def leads_to(self, path):
        """The file that a link to `path` opens: itself, or the page that shows it."""
        source = os.path.join(self.sources, path)
        if os.path.isdir(source):
            readme = posixpath.join(path, "README.md")
            return self.want(readme if os.path.exists(os.path.join(self.sources, readme)) else posixpath.join(path, "index.md"))
        if path.endswith(".md"):
            return self.want(path)
        kind = os.path.splitext(path)[1]
        if kind in SHOWN and os.path.getsize(source) <= LARGEST:
            return self.want(path + ".md")
        return self.copy(path)

    def copy(self, path):
        os.makedirs(os.path.dirname(os.path.join(self.folder, path)), exist_ok=True)
        shutil.copyfile(os.path.join(self.sources, path), os.path.join(self.folder, path))
        return path

    def want(self, page):
        if page not in self.made:
            self.made.add(page)
            self.waiting.append(page)
        return page

    def make(self, page):
        if os.path.exists(os.path.join(self.sources, page)):
            return self.add(page, self.read(page))
        name = page.removesuffix(".md")
        if posixpath.basename(page) == "index.md":
            return self.list(posixpath.dirname(page))
        kind = SHOWN[os.path.splitext(name)[1]]
        return self.write(page, f"# `{name}`\n\n~~~~~~{kind}\n{self.read(name)}\n~~~~~~\n")

    def list(self, path):
        """The page of a folder: its texts open as they are."""
        lines = []
        for entry in sorted(os.scandir(os.path.join(self.sources, path)), key=lambda e: e.name):
            if not entry.name.startswith((".", "__")):
                found = posixpath.join(path, entry.name)
                found = self.leads_to(found) if entry.is_dir() or entry.name.endswith(".md") else self.copy(found)
                lines.append(f"- [{entry.name}]({posixpath.relpath(found, path)})\n")
        self.write(posixpath.join(path, "index.md"), f"# `{path}/`\n\n" + "".join(lines))

    def finish(self):
        while self.waiting:
            self.make(self.waiting.pop())


def command_line(program):
    """The page of the command line, which is what the program says of itself."""

    def told(*arguments):
        return subprocess.run([program, *arguments, "--help"], check=True, stdout=subprocess.PIPE, text=True).stdout

    whole = told()
    text = f"# The command line\n\n```\n{whole}```\n"
    for name in re.findall(r"^  ([a-z]+) {2,}", whole.split("Subcommands:")[1], re.MULTILINE):
        text += f"\n## `slipproof {name}`\n\n```\n{told(name).split('Exit codes:')[0].rstrip()}\n```\n"
    return text


def glossary(meaning):
    return re.sub("^#+", "#", meaning[meaning.index("## Glossary"):])


def navigation(pages, sections):
    """The sections with all papers in theirs; each page of the project must stand in one."""
    listed = {entry for entries in sections.values() for entry in entries if isinstance(entry, str)}
    papers = sorted(p for p in pages if re.fullmatch(r"proofs/[^/]+/README[.]md", p) and p not in listed)
    missing = sorted(set(pages) - listed - set(papers))
    if missing:
        sys.exit(f"{HERE}/mkdocs.yml: found no section for {', '.join(missing)}")
    return [{section: papers if entries == "papers" else entries} for section, entries in sections.items()]


def plain(text):
    """A text without its accents."""
    return "".join(c for c in unicodedata.normalize("NFD", text) if not unicodedata.combining(c))


def carry_search(site, project):
    """The index and the worker of the search as a script, without the pages that only show files. Words with accents stand
    in the index without them, too: Painlevé is found as painleve."""
    with open(os.path.join(site, "search/search_index.json"), encoding="utf-8") as file:
        index = json.load(file)
    found = {re.sub("README$", "index", page.removesuffix(".md")) + ".html" for page in project}
    index["docs"] = [entry for entry in index["docs"] if entry["location"].partition("#")[0] in found]
    for entry in index["docs"]:
        words = re.findall(r"\w+", f"{entry['title']} {entry['text']}")
        entry["text"] += "".join(f" {plain(word)}" for word in words if plain(word) != word)
    workers = os.path.join(site, "assets/javascripts/workers")
    worker = next(name for name in sorted(os.listdir(workers)) if re.fullmatch(r"search\..*\.min\.js", name))
    with open(os.path.join(workers, worker), encoding="utf-8") as file:
        code = file.read()
    with open(os.path.join(site, "search/offline.js"), "w", encoding="utf-8") as file:
        file.write(f"""const asks = new Set("a an and are can do does for from how i in is it my of on or the to what when where which who why with".split(" "));
var __search = {{
  index: Promise.resolve({json.dumps(index)}),
  worker: URL.createObjectURL(new Blob([{json.dumps(code)}], {{type: "text/javascript"}})),
  // A whole word counts more than the beginning of one, and the words that only make a question do not count.
  transform: query => query.replace(/[^\\s":*^~+-]+/g, word => asks.has(word.toLowerCase()) ? "" : `${{word}}^10 ${{word}}*`),
}};
""")


def mend(out):
    """The name or logo of each page leads to the site's front page; MkDocs leads no link out of its folder, and a report knows
    of none. For who uses keys or a screen reader, the theme's search gets a name and its menu a button; a column without a
    heading gets no empty one."""
    name_leads = re.compile(r'(<a class="brand" href=")[^"]*|(<a href=")[^"]*(?="[^>]*md-logo)')
    menu = re.compile(r'<label class="(md-header__button md-icon)" for="__drawer">(.*?)</label>', re.DOTALL)
    no_heading = re.compile(r"<th( [^>]*)?></th>")
    for folder, _, names in (found for part in ("pages", "papers", "engines") for found in os.walk(os.path.join(out, part))):
        front = os.path.relpath(os.path.join(out, "index.html"), folder)
        for path in (os.path.join(folder, name) for name in names if name.endswith(".html")):
            with open(path, encoding="utf-8") as file:
                text = file.read()
            text = name_leads.sub(lambda link: (link[1] or link[2]) + front, text)
            text = no_heading.sub(r"<td\1></td>", text)
            text = text.replace('role="dialog"', 'role="dialog" aria-label="Search"')
            text = menu.sub(r'<button class="\1 menu" aria-label="Menu">\2</button>', text)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)


def main(sources, built, out):
    with open(os.path.join(HERE, "mkdocs.yml"), encoding="utf-8") as file:
        sections = yaml.load(file, yaml.BaseLoader)["extra"]["sections"]
    folder, site = os.path.join(out, "markdown"), os.path.join(out, "pages")
    shutil.rmtree(site, ignore_errors=True)
    shutil.rmtree(folder, ignore_errors=True)
    pages = Pages(sources, folder)
    for root, folders, files in os.walk(sources):
        folders[:] = sorted(f for f in folders if not f.startswith((".", "build")) and f != "node_modules")
        for name in sorted(files):
            if name.endswith(".md"):
                pages.want(posixpath.normpath(posixpath.join(os.path.relpath(root, sources), name)))
    project = [*pages.made, COMMAND_LINE, GLOSSARY]
    pages.finish()
    pages.write(GLOSSARY, glossary(pages.read("proofs/MEANING.md")))
    pages.write(COMMAND_LINE, command_line(os.path.join(built, "slipproof")))
    build(load_config(os.path.join(HERE, "mkdocs.yml"), docs_dir=folder, site_dir=site, strict=True,
                      nav=navigation(project, sections)))
    carry_search(site, project)
    mend(out)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main(*(os.path.abspath(argument) for argument in sys.argv[1:4]))
