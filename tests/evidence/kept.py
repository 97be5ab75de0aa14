"""kept.py - findings that stay, with what is said about them: files of blocks

    FILE
      TEXT
      TEXT
        REASON of all since the last reason, also of several files, in one or more lines

TEXT is a line of the source, or a finding without its line number, so that an entry survives changes elsewhere."""


def parse(text):
    """By (file, text), the reason."""
    found, source, group, reason = {}, None, [], False
    for line in text.splitlines():
        if not line or line.startswith("#"):
            continue
        if line.startswith("    "):
            reason = True
            for key in group:
                found[key] = f"{found[key]} {line.strip()}".strip()
            continue
        if reason:
            group, reason = [], False
        if not line.startswith(" "):
            source = line
        else:
            group.append((source, line.strip()))
            found[group[-1]] = ""
    return found


def read(path):
    with open(path, encoding="utf-8") as file:
        return parse(file.read())


def compare(found, kept):
    """(findings without a reason, reasons without a finding), both as (file, text)."""
    return sorted(key for key in found if not kept.get(key)), sorted(key for key in kept if key not in found)
