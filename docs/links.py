"""Check every link, picture and script of a built site: it leads to a page, file and heading of the site.

    python docs/links.py build/site     exit code 1 if one does not

Links to other servers are for readers to follow: nothing on a page may load from there.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {"img", "script", "iframe", "link", "source", "video"}


class Page(HTMLParser):
    """The links and the anchors of one page."""

    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], {""}
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        self.links += [(tag, values[name]) for name in ("href", "src", "data-page") if values.get(name)]


def broken(site):
    """What is wrong, a line for each link."""
    pages = {file.resolve(): Page(file) for file in site.rglob("*.html")}
    for file, page in pages.items():
        for tag, link in page.links:
            if problem := _problem(file, tag, link, pages):
                yield f"{file.relative_to(site.resolve())}: {link}: {problem}"


def _problem(file, tag, link, pages):
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return "it loads from another server" if tag in LOADED and parts.scheme != "data" else ""
    target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
    if not target.is_file():
        return "there is no such file"
    if target in pages and unquote(parts.fragment) not in pages[target].anchors:
        return "there is no such heading"
    return ""


if __name__ == "__main__":
    problems = list(broken(Path(sys.argv[1])))
    print("\n".join(problems) or "all links lead to where they say")
    sys.exit(bool(problems))
