"""The site: `make docs` writes it into build/site. Pages about assignments and lectures are made from the code."""

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "extension"))

import tam570  # noqa: E402

project = "tam570"
author = "The tam570 authors"
copyright = f"{author}. MIT license. Version {tam570.__version__}"
version = release = tam570.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "figures",
    "mathematics",
    "pages",
    "scenes",
    "trim",
]
exclude_patterns = [
    "extension",
    "lectures",
    "problems",
    "generated/figures",
    "generated/lectures.md",
    "generated/stills.md",
]
nitpicky = True
suppress_warnings = ["misc.highlighting_failure"]
default_role = "code"
templates_path = ["_templates"]

myst_enable_extensions = ["colon_fence", "dollarmath", "attrs_inline"]
myst_heading_anchors = 3
autodoc_typehints = "none"
napoleon_google_docstring = False
napoleon_use_param = napoleon_use_rtype = False
nitpick_ignore = [("py:exc", "Unknown")]
autodoc_member_order = "bysource"
add_module_names = False
html_math_renderer = "mathml"

html_theme = "pydata_sphinx_theme"
html_title = "tam570"
html_favicon = "_static/icon.svg"
html_context = {"default_mode": "auto"}
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = [("scenes.js", {"defer": "defer"})]
html_copy_source = False
html_use_index = html_domain_indices = False
html_show_sourcelink = False
html_show_search_summary = False  # it fetches pages, which a browser refuses without a server
html_theme_options = {
    "logo": {"text": "tam570"},
    "back_to_top_button": False,
    "header_links_before_dropdown": 7,
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "secondary_sidebar_items": ["page-toc"],
    "show_toc_level": 2,
    "navigation_depth": 3,
    "pygments_light_style": "a11y-high-contrast-light",
    "pygments_dark_style": "a11y-high-contrast-dark",
}
html_sidebars = {"index": [], "changes": [], "benchmarks": [], "design": []}
