"""The rules by which mutants are made: each takes the code of a file and gives changes of it."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from tokens import NO_CODE, Code


@dataclass(frozen=True)
class Change:
    rule: str
    start: int
    end: int
    text: str  # instead of what stands there


# By what an operator is replaced, where it stands between blanks.
BINARY = {
    "relational": {"<": "<= >=", "<=": "< >", ">": ">= <=", ">=": "> <", "==": "!=", "!=": "=="},
    "arithmetic": {"+": "-", "-": "+", "*": "+", "/": "*", "%": "*", "+=": "-=", "-=": "+=", "*=": "+=", "/=": "*="},
    "bits": {"&": "|", "|": "&", "^": "|", "<<": ">>", ">>": "<<", "&=": "|=", "|=": "&=", "^=": "|=", "<<=": ">>=",
             ">>=": "<<="},
    "logical": {"&&": "||", "||": "&&"},
}
UNARY = {"-": "arithmetic", "~": "bits", "!": "logical"}  # dropped
DECLARES = set("using typedef struct class enum union namespace template friend static const constexpr inline auto "
               "explicit virtual extern public private protected operator".split())
CONTROLS = {"if", "for", "while", "do", "switch", "else", "case", "default", "try", "catch", "return", "goto"}
SYMMETRIC = {"min", "max", "swap", "dot"}  # nothing changes when their arguments are swapped


def operators(code: Code) -> Iterator[Change]:
    for k, token in enumerate(code.tokens):
        if code.is_left_alone[k] or token.kind != "op" or code.word(k - 1) == "operator":
            continue
        if token.is_between_blanks and not is_concatenation(code, k):
            for rule, table in BINARY.items():
                for other in table.get(token.text, "").split():
                    yield Change(rule, token.start, token.end, other)
        elif token.text in ("++", "--"):
            yield Change("arithmetic", token.start, token.end, "--" if token.text == "++" else "++")
        elif token.text in UNARY and not token.blank_after and not is_destructor(code, k):
            if token.blank_before or code.op(k - 1) in ("(", "[", "{", "!", "-", "~"):
                yield Change(UNARY[token.text], token.start, token.end, "")


def is_concatenation(code: Code, k: int) -> bool:
    return code.op(k) == "+" and "text" in (code.tokens[k - 1].kind, code.tokens[k + 1].kind)


def is_destructor(code: Code, k: int) -> bool:
    return code.op(k) == "~" and is_declarative(code, code.parent[k])


NUMBER = re.compile(r"(0[xX][\da-fA-F']+|(?:0|[1-9][\d']*)(?P<fraction>\.\d*)?)(?P<suffix>[a-zA-Z]*)")


def constants(code: Code) -> Iterator[Change]:
    for k, token in enumerate(code.tokens):
        if code.is_left_alone[k]:
            continue
        if token.text in ("true", "false"):
            yield Change("constants", token.start, token.end, "false" if token.text == "true" else "true")
        elif token.kind == "number" and (match := NUMBER.fullmatch(token.text)):
            digits = match[1].replace("'", "")
            value = float(digits) if match["fraction"] else int(digits, 0)
            for other in (value + 1, value - 1):
                text = f"{other}{match['suffix']}"
                yield Change("constants", token.start, token.end, text if other >= 0 else f"({text})")


def conditions(code: Code) -> Iterator[Change]:
    """Of `if` and `while` the opposite; before a question mark one that always holds, and one that never does."""
    for k, token in enumerate(code.tokens):
        if token.text == "(" and code.word(k - 1) in ("if", "while"):
            inside = code.children(k)
            first = next((i + 1 for i in reversed(inside) if code.op(i) == ";"), k + 1)
            last = code.partner[k] - 1
            operators_inside = [code.op(i) for i in inside if code.op(i) and code.tokens[i].is_between_blanks]
            if not declares(code, first) and operators_inside not in (["=="], ["!="]):  # those are relational mutants
                yield Change("conditions", code.tokens[first].start, code.tokens[last].end,
                             f"!({code.between(first, last)})")
        elif token.text == "?" and not code.is_left_alone[k]:
            yield Change("conditions", token.start, token.end, "|| true ?")
            yield Change("conditions", token.start, token.end, "&& false ?")


def declares(code: Code, k: int) -> bool:
    """Whether a declaration begins there: a type, and then a name."""
    if code.word(k) in DECLARES:
        return True
    if not code.word(k) or code.word(k) in CONTROLS:
        return False
    k += 1
    while code.op(k) == "::" or (code.op(k) == "<" and k in code.partner):
        k = k + 2 if code.op(k) == "::" else code.partner[k] + 1
    while code.op(k) in ("*", "&", "&&") and not code.tokens[k].blank_before:
        k += 1
    return bool(code.word(k))


def is_declarative(code: Code, bracket: int) -> bool:
    """Whether a brace holds declarations: of a namespace, or of a type. Outside of all braces there are only those."""
    if bracket < 0:
        return True
    if code.op(bracket) != "{":
        return False
    k = bracket - 1
    while k >= 0 and code.op(k) not in (";", "{", "}", ")"):
        if code.word(k) in ("namespace", "struct", "class", "enum", "union"):
            return True
        k -= 1
    return False


def statements(code: Code) -> Iterator[Change]:
    """Drops one. A `return` with a value only where it is all that an `if` or a loop does: what follows returns too."""
    for k in range(1, len(code.tokens)):
        before = code.tokens[k - 1].text
        guarded = before == "else" or (before == ")" and code.word(code.partner.get(k - 1, 0) - 1) in CONTROLS)
        if not guarded and before not in (";", "{", "}"):
            continue
        if code.is_left_alone[k] or code.op(code.parent[k]) != "{" or is_declarative(code, code.parent[k]):
            continue
        word = code.word(k)
        if word == "return":
            drop = guarded or code.op(k + 1) == ";"
        elif word:
            drop = word not in CONTROLS | NO_CODE and not declares(code, k)
        else:
            drop = code.op(k) in ("++", "--")
        if not drop:
            continue
        last = end_of_statement(code, k)
        if last:
            yield Change("statements", code.tokens[k].start, code.tokens[last - 1].end, "")


def end_of_statement(code: Code, k: int) -> int:
    """The semicolon that ends what begins there; 0 if none does."""
    while k < len(code.tokens) and code.op(k) != "}":
        if code.op(k) == ";":
            return k
        k = max(code.partner.get(k, k), k) + 1
    return 0


def arguments(code: Code) -> Iterator[Change]:
    """Swaps two neighbours, in a call or in braces."""
    for bracket, end in code.partner.items():
        if bracket > end or code.is_left_alone[bracket] or not is_list_of_values(code, bracket):
            continue
        parts: list[list[int]] = [[]]
        for k in code.children(bracket):
            if code.op(k) == ",":
                parts.append([])
            else:
                parts[-1].append(k)
        if any(not part or declares(code, part[0]) for part in parts):
            continue
        for one, other in zip(parts, parts[1:]):
            first, second = code.between(one[0], one[-1]), code.between(other[0], other[-1])
            if first != second:
                yield Change("arguments", code.tokens[one[0]].start, code.tokens[other[-1]].end, f"{second}, {first}")


def is_list_of_values(code: Code, bracket: int) -> bool:
    before = bracket - 1
    if code.op(bracket) == "(":
        if code.op(before) == ">" and before in code.partner:
            before = code.partner[before] - 1
        return bool(code.word(before)) and code.word(before) not in CONTROLS | SYMMETRIC
    if code.op(bracket) != "{" or is_declarative(code, bracket):
        return False
    if any(code.op(k) == ";" for k in code.children(bracket)):  # statements
        return False
    return bool(code.word(before)) or code.op(before) in ("(", "{", ",", "=", ">")


RULES = (operators, constants, conditions, statements, arguments)


def changes_of(text: str) -> list[Change]:
    code = Code(text)
    return sorted((change for rule in RULES for change in rule(code)), key=lambda c: (c.start, c.end, c.rule, c.text))
