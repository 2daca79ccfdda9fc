"""C++ as a list of tokens: enough to make mutants of code that clang-format has laid out.

What is leaned on: a binary operator stands between blanks, an operator that belongs to one operand touches it, and so
do the brackets of a template's arguments.
"""

import re
from dataclasses import dataclass

PIECES = re.compile(r"""
    (?P<skip> \s+ | //[^\n]* | /\*.*?\*/ | \#(?:[^\n\\]|\\\n|\\.)* )
  | (?P<text> (?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)" | (?:u8|[uUL])?"(?:[^"\\]|\\.)*" | '(?:[^'\\]|\\.)+' )
  | (?P<number> \.?\d(?:[eEpP][+-]|'?[\w.])* )
  | (?P<word> [A-Za-z_]\w* )
  | (?P<op> (?<=\s)(?:<=>|<<=|>>=|<<|>>|<=|>=)(?=\s)
          | ->\*? | :: | \.\.\. | \+\+ | -- | && | \|\| | [-+*/%&|^=!]= | [^\s\w] )
""", re.VERBOSE | re.DOTALL)

CLOSING = {")": "(", "]": "[", "}": "{"}
NO_CODE = {"assert", "static_assert", "template", "alignas", "requires"}  # brackets after these are left alone


@dataclass(frozen=True)
class Token:
    kind: str
    text: str
    start: int
    end: int
    blank_before: bool
    blank_after: bool

    @property
    def is_between_blanks(self) -> bool:
        return self.blank_before and self.blank_after


def tokens_of(code: str) -> list[Token]:
    tokens, at = [], 0
    while at < len(code):
        match = PIECES.match(code, at)
        if match.lastgroup != "skip":
            end = match.end()
            tokens.append(Token(match.lastgroup, match[0], at, end, at == 0 or code[at - 1].isspace(),
                                end == len(code) or code[end].isspace()))
        at = match.end()
    return tokens


class Code:
    """The tokens of a file and how its brackets match. By the index of a token: `partner`, of a bracket, the other one;
    `parent`, the bracket around it, or -1; `is_left_alone`, whether it is no code that runs."""

    def __init__(self, text: str):
        self.text = text
        self.tokens = tokens_of(text)
        self.partner: dict[int, int] = {}
        self.parent: list[int] = []
        open_brackets: list[int] = []
        for k, token in enumerate(self.tokens):
            if token.text in CLOSING or (token.text == ">" and self.closes_angle(token, open_brackets)):
                while open_brackets and self.tokens[open_brackets[-1]].text != CLOSING.get(token.text, "<"):
                    open_brackets.pop()
                if open_brackets:
                    other = open_brackets.pop()
                    self.partner[other], self.partner[k] = k, other
            self.parent.append(open_brackets[-1] if open_brackets else -1)
            if token.text in CLOSING.values() or (token.text == "<" and self.opens_angle(k)):
                open_brackets.append(k)
        self.is_left_alone = self.find_left_alone()

    def opens_angle(self, k: int) -> bool:
        return not self.tokens[k].blank_after and self.word(k - 1) not in ("", "operator")

    def closes_angle(self, token: Token, open_brackets: list[int]) -> bool:
        return not token.blank_before and bool(open_brackets) and self.tokens[open_brackets[-1]].text == "<"

    def find_left_alone(self) -> list[bool]:
        alone = [False] * len(self.tokens)
        for begin, end in self.partner.items():
            bracket = self.tokens[begin].text
            attribute = bracket == "[" and self.op(begin + 1) == "["
            if begin < end and (bracket == "<" or attribute or self.word(begin - 1) in NO_CODE):
                alone[begin:end + 1] = [True] * (end + 1 - begin)
        return alone

    def word(self, k: int) -> str:
        return self.tokens[k].text if 0 <= k < len(self.tokens) and self.tokens[k].kind == "word" else ""

    def op(self, k: int) -> str:
        return self.tokens[k].text if 0 <= k < len(self.tokens) and self.tokens[k].kind == "op" else ""

    def between(self, first: int, last: int) -> str:
        """The text of tokens first … last."""
        return self.text[self.tokens[first].start:self.tokens[last].end]

    def children(self, bracket: int) -> list[int]:
        """The tokens in a bracket, without what stands in brackets in it: of those only the brackets."""
        inside, k = [], bracket + 1
        while k < self.partner[bracket]:
            inside.append(k)
            k = self.partner.get(k, k) if self.partner.get(k, k) > k else k
            if inside[-1] != k:
                inside.append(k)
            k += 1
        return inside
