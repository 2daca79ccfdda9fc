#!/usr/bin/env python3
"""Shows a public header to Doxygen, as its readers understand it: scripts/doxygen_filter.py HEADER

- The comment at the top is about the file.
- In C a comment is about what follows, or about what stands before it on its line.
- A comment beside several fields is about each of them.
- A comment holds for functions that follow each other line by line: in C++ if they have the same name.
- Comparisons of values, member by member, and hashes need no words; they are left out.
"""
import re
import sys

FUNCTION = re.compile(r"([\w~]+|operator\S+?)\(")
BEGINS_COMMENT = re.compile(r"(///|/\*\*)(?!<)")
ENDS = re.compile(r"[;{}]\s*(//.*|/\*.*)?$")
HASH = re.compile(r"(?m)^(///[^\n]*\n)?template <>\nstruct std::hash<[\s\S]*?^};")
COMPARISON = re.compile(r"\s*friend .*operator(==|<=>)\(.*[;]\s*(//.*)?$")


def is_code(line):
    return line.startswith("   ")


def plain(line):
    """Without what Doxygen would take for a tag or for a list that does not begin at 1."""
    return re.sub(r"^ +(\d+)\. ", r"<br>(\1) ", line.replace("<", "\\<"))


def about_file(lines):
    """The text of the first comment, with its code marked as such. It may begin in the middle of a sentence's line."""
    out, inside = ["/// \\file"], False
    for k, line in enumerate(lines):
        code = is_code(line) and (inside or k == 0 or not lines[k - 1].strip())
        if code != inside and (code or line.strip()):
            out.append("/// \\code" if code else "/// \\endcode")
            inside = code
        out.append(f"/// {line if inside else plain(line)}")
    return out + (["/// \\endcode"] if inside else [])


def from_c(text):
    """Turns /* */ into comments for Doxygen, and gives each field a line of its own."""
    def turned(match):
        before, body = match[1], match[2]
        if body.startswith((" ---", " NOLINT")):
            return before
        return f"{before}/**{'<' if before.strip() else ''}{body}*/"
    text = re.sub(r"(?m)^([^\n]*?)/\*((?:(?!\*/)[\s\S])*)\*/", turned, text)
    return re.sub(r"(?m)^( *\w+ )(\w+\[\d\](?:, \w+\[\d\])+); *(/\*.*)$",
                  lambda fields: "\n".join(f"{fields[1]}{field}; {fields[3]}" for field in fields[2].split(", ")), text)


def split_top(text):
    """The lines of the first comment, without its signs, and the rest."""
    if text.startswith("/*"):
        body, rest = text[2:].split("*/", 1)
        return [re.sub(r"^ ?\*? ?", "", line) if k else line.strip() for k, line in enumerate(body.splitlines())], rest
    top = re.match(r"(//[^\n]*\n)+", text)[0]
    return [re.sub(r"^// ?", "", line) for line in top.splitlines()], text[len(top):]


def repeated(lines, is_c):
    """Repeats a comment for the functions that follow the one that it stands before, line by line."""
    out, comment, name = [], [], None  # the comment of a run of functions, and the name of the last one
    in_comment = in_statement = False
    for line in lines:
        stripped = line.strip()
        if COMPARISON.match(line):
            continue
        if in_statement:
            in_statement = not ENDS.search(stripped)
        elif in_comment or BEGINS_COMMENT.match(stripped):
            comment = comment + [line] if in_comment or not name else [line]
            name = None
            in_comment = not stripped.endswith("*/") if in_comment or stripped.startswith("/**") else False
        elif not stripped or stripped.startswith(("#", "//", "extern")):
            comment, name = [], None
        else:
            found = FUNCTION.search(stripped)
            this = found[1] if found else None
            if name and this and (is_c or this in (name, "operator=")) and "///<" not in line:
                out += comment
            name = this or "no function"
            in_statement = not ENDS.search(stripped)
        out.append(line)
    return out


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    top, rest = split_top(text)
    is_c = text.startswith("/*")
    if is_c:
        rest = from_c(rest)
    rest = HASH.sub("", rest)
    print("\n".join(about_file(top)))
    print("\n".join(repeated(rest.splitlines(), is_c)))


if __name__ == "__main__":
    main()
