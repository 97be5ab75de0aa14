#!/usr/bin/env python3
"""Writes the project's home page, from package/home.txt, into the manifests of the packages, and its mail address into
Debian's. Manifests leave out what is empty there.

manifests.py [FOLDER [HOME]]: FOLDER gets the manifests, by default the source tree; HOME is another home.txt.
"""
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
# A manifest, the beginning of the line above the home page's, and that line.
JSON = '  "homepage": "{}",'
HOMEPAGES = (("idf_component.yml", "description: ", "url: {}"),
             ("library.json", '  "description": ', JSON),
             ("package/arduino/library.properties", "category=", "url={}"),
             ("package/debian/control", "Standards-Version: ", "Homepage: {}"),
             ("package/debian/copyright", "Upstream-Name: ", "Source: {}"),
             ("package/editors/pygments/pyproject.toml", "description = ", 'urls = {{Homepage = "{}"}}'),
             ("package/editors/vscode/package.json", '  "description": ', JSON),
             ("package/npm/package.json", '  "description": ', JSON),
             ("package/python/setup.py", "setup(name=", '      url="{}",'))
# Debian's tools refuse packages whose maintainer has no address; names below .invalid are nobody's, RFC 2606.
NOWHERE = "tia@tia.invalid"
MAILS = (("package/debian/control", "Maintainer: "), ("package/debian/changelog", " -- "))
MANIFESTS = sorted({row[0] for row in HOMEPAGES + MAILS})


def home(path=os.path.join(ROOT, "package/home.txt")):
    """Returns the settings by their names."""
    with open(path, encoding="utf-8") as file:
        return dict(re.findall(r"^(\w+) *= *(.*?) *$", file.read(), re.M))


def filled(name, text, settings):
    """Returns the text of the manifest `name` with these settings."""
    for manifest, before, line in HOMEPAGES:
        if manifest == name:
            old = "^" + re.escape(line.format("@")).replace("@", ".*") + r"\n"
            text = re.sub(old, "", text, flags=re.M)
            new = line.format(settings["homepage"]) + "\n" if settings["homepage"] else ""
            text, count = re.subn(f"^{re.escape(before)}.*\n", lambda match, new=new: match[0] + new, text, flags=re.M)
            if count != 1:
                sys.exit(f"{name}: {count} lines begin with {before!r}")
    for manifest, before in MAILS:
        if manifest == name:
            text = re.sub(f"^({before}.*<).*?>", lambda match: f"{match[1]}{settings['mail'] or NOWHERE}>", text, flags=re.M)
    return text


def main():
    folder = (sys.argv[1:] + [ROOT])[0]
    settings = home(*sys.argv[2:])
    for name in MANIFESTS:
        with open(os.path.join(ROOT, name), encoding="utf-8") as file:
            text = filled(name, file.read(), settings)
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
