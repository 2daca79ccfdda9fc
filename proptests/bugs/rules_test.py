"""Which mutants are made of a line of code, and which are not; and that the table of components is up to date."""

import unittest

import mutation
import package
from components import COMPONENTS
from rules import changes_of
from workshop import ROOT

INSIDE = "void f() {{\n  {}\n}}\n"
IN_CLASS = "struct A {{\n  {}\n}};\n"


class Rules(unittest.TestCase):
    def check(self, rule: str, line: str, *expected: str, frame: str = INSIDE) -> None:
        """The line as each mutant of the rule has it."""
        text = frame.format(line)
        begin, after = text.index(line), len(text) - text.index(line) - len(line)
        mutants = [text[begin:c.start] + c.text + text[c.end:-after] for c in changes_of(text) if c.rule == rule]
        self.assertCountEqual(mutants, expected, line)

    def test_relational(self):
        self.check("relational", "a < b;", "a <= b;", "a >= b;")
        self.check("relational", "x = std::max<int>(a, b) == c;", "x = std::max<int>(a, b) != c;")
        self.check("relational", "bool operator<(const A& b) const;", frame=IN_CLASS)

    def test_arithmetic(self):
        self.check("arithmetic", "x = a - -b;", "x = a + -b;", "x = a - b;")
        self.check("arithmetic", "for (; i; ++i) n += 2;", "for (; i; --i) n += 2;", "for (; i; ++i) n -= 2;")
        self.check("arithmetic", 'text = "a" + b + "c";')
        self.check("arithmetic", "T* p = *q;")

    def test_bits(self):
        self.check("bits", "x &= ~(a >> 3 | b);", "x |= ~(a >> 3 | b);", "x &= (a >> 3 | b);", "x &= ~(a << 3 | b);",
                   "x &= ~(a >> 3 & b);")
        self.check("bits", "T&& x = f<A<B>>(y);")
        self.check("bits", "~A();", frame=IN_CLASS)

    def test_logical(self):
        self.check("logical", "if (!a && b) return;", "if (a && b) return;", "if (!a || b) return;")

    def test_constants(self):
        self.check("constants", "x = 4'096u;", "x = 4097u;", "x = 4095u;")
        self.check("constants", "x = 0x10;", "x = 17;", "x = 15;")
        self.check("constants", "x = 0;", "x = 1;", "x = (-1);")
        self.check("constants", "x = 0.5F;", "x = 1.5F;", "x = (-0.5F);")
        self.check("constants", "x = true;", "x = false;")
        self.check("constants", "f<3>('4', \"5\");  // 6")

    def test_conditions(self):
        self.check("conditions", "while (a && b) f();", "while (!(a && b)) f();")
        self.check("conditions", "if (const T* p = g(); p) f();", "if (const T* p = g(); !(p)) f();")
        self.check("conditions", "if (const T* p = g()) f();")
        self.check("conditions", "if (a == b) f();")  # it is a relational mutant
        self.check("conditions", "x = a ? b : c;", "x = a || true ? b : c;", "x = a && false ? b : c;")

    def test_statements(self):
        self.check("statements", "f(a); ++b;", "; ++b;", "f(a); ;")
        self.check("statements", "if (a) return b;", "if (a) ;")
        self.check("statements", "if (a) { b = c; }", "if (a) { ; }")
        self.check("statements", "for (int i = 0; i < n; ++i) a.b[i] = c;", "for (int i = 0; i < n; ++i) ;")
        self.check("statements", "sort(v, [](A a) { g(a); });", ";", "sort(v, [](A a) { ; });")
        for line in ("return b;", "const int a = b;", "std::vector<int> a(b);", "T& a = b;", "using A = B;",
                     "assert(a);", "int c = A{1}.b(2);"):
            self.check("statements", line)
        self.check("statements", "A() = default;", frame=IN_CLASS)

    def test_arguments(self):
        self.check("arguments", "f(a, g(b, c));", "f(g(b, c), a);", "f(a, g(c, b));")
        self.check("arguments", "return {a, b};", "return {b, a};")
        for line in ("x = std::max(a, b);", "f(a, a);", "void g(int a, T& b);", "std::pair<A, B> p;"):
            self.check("arguments", line)

    def test_what_is_left_alone(self):
        for line in ("assert(a < b + 1);", 'static_assert(sizeof(A) == 4, "1 < 2");', "// a < b + 1",
                     "/* f(a, b); */", "#define A (1 < 2)", "template <int N = 3>", "[[maybe_unused]] int a;",
                     'const auto a = R"(1 < 2)";'):
            self.assertEqual(changes_of(INSIDE.format(line)), [], line)


class Components(unittest.TestCase):
    def test_every_folder_has_code(self):
        for name, component in COMPONENTS.items():
            files = mutation.files_of(name)
            for folder in component.folders:
                self.assertTrue(any(file.startswith(f"{folder}/") for file in files), folder)

    def test_what_is_left_out_is_there(self):
        for component in COMPONENTS.values():
            for file in component.without:
                self.assertTrue((ROOT / file).is_file(), file)
        for name in package.OF_OTHER_THINGS:
            self.assertTrue((ROOT / package.FOLDER / "test" / f"{name}.test.js").is_file(), name)


if __name__ == "__main__":
    unittest.main()
