"""Mutants of C++ headers: finds the places by libclang, writes text in which each mutant has a switch at run time."""
import bisect
import dataclasses
import pathlib
import re

from clang import cindex
from clang.cindex import CursorKind as kind
from clang.cindex import TypeKind

shifted = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
integers = {TypeKind.CHAR_U, TypeKind.UCHAR, TypeKind.USHORT, TypeKind.UINT, TypeKind.ULONG, TypeKind.ULONGLONG,
            TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.SHORT, TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG}
arithmetic = integers | {TypeKind.FLOAT, TypeKind.DOUBLE}
# Contain constant expressions or types only.
constant = {kind.STATIC_ASSERT, kind.CXX_UNARY_EXPR, kind.TYPE_REF, kind.TEMPLATE_REF, kind.NAMESPACE_REF, kind.TYPEDEF_DECL,
            kind.TYPE_ALIAS_DECL, kind.ENUM_DECL, kind.PARM_DECL, kind.USING_DECLARATION}
functions = {kind.FUNCTION_DECL, kind.CXX_METHOD, kind.CONSTRUCTOR, kind.FUNCTION_TEMPLATE}
loops = {kind.WHILE_STMT, kind.FOR_STMT, kind.DO_STMT}


@dataclasses.dataclass
class mutant:
    module: str
    file: str  # relative to the top of the tree
    start: int  # bytes of the file
    end: int
    line: int
    kind: str
    change: str  # for readers, in one line
    form: str  # "value", "condition", "cast TYPE", "statement", "return" or "declaration": how it is written
    text: str  # what replaces the range, or is inserted
    line_text: str = ""
    number: int = 0

    def key(self):
        return f"{self.file}:{self.line}: {self.kind}: {self.change} @{self.start}"


def one_line(text):
    return re.sub(r"\s+", " ", re.sub(r"//[^\n]*", "", text)).strip()


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S).strip()


class finder:
    """Finds the mutants of one file."""

    def __init__(self, module, name, text):
        self.module, self.name, self.text = module, name, text
        self.found = {}
        self.kept = set()  # where statements start that are not left out
        self.line_starts = [0] + [at.end() for at in re.finditer("\n", text)]

    def add(self, what, start, end, change, form, text):
        line = bisect.bisect_right(self.line_starts, start)
        line_text = self.text[self.line_starts[line - 1]:].split("\n", 1)[0].strip()
        made = mutant(self.module, self.name, start, end, line, what, one_line(change), form, text, line_text)
        self.found.setdefault((start, end, what, made.change), made)

    def text_of(self, cursor):
        return self.text[cursor.extent.start.offset:cursor.extent.end.offset]

    def is_here(self, cursor):
        begin, end = cursor.extent.start, cursor.extent.end
        return bool(begin.file) and begin.file.name.endswith(self.name) and begin.offset < end.offset <= len(self.text)

    def walk(self, cursor, parent, is_body, in_lambda):
        if cursor.kind in constant or (cursor.kind in functions and self.is_here(cursor) and
                                       "consteval" in self.text_of(cursor).split("{")[0]):
            return
        if cursor.kind == kind.COMPOUND_STMT:
            is_body = True
        elif cursor.kind == kind.LAMBDA_EXPR:
            in_lambda = True
        children = list(cursor.get_children())
        if is_body and self.is_here(cursor):
            children = self.mutate(cursor, parent, children, in_lambda)
        for child in children:
            self.walk(child, cursor, is_body, in_lambda)

    def mutate(self, cursor, parent, children, in_lambda):
        """Adds the mutants of this node; returns the children in which others may be."""
        what = cursor.kind
        if what == kind.IF_STMT:
            return self.mutate_if(cursor, children)
        if what in (kind.CASE_STMT, kind.DEFAULT_STMT):
            children = children[1:] if what == kind.CASE_STMT else children
            self.leave_out(children)
        elif what == kind.COMPOUND_STMT:
            if parent is not None and parent.kind == kind.SWITCH_STMT and children:
                self.keep_last_break(children[-1])
            self.leave_out(children)
        elif what in loops or what == kind.CXX_FOR_RANGE_STMT:
            self.mutate_loop(cursor, children)
        elif what == kind.CONDITIONAL_OPERATOR and len(children) == 3:
            self.negate(children[0])
        elif what == kind.RETURN_STMT and children:
            self.mutate_return(cursor, children[0], in_lambda)
        elif what == kind.DECL_STMT:
            if re.search(r"\bconstexpr\b", self.text_of(cursor).split("=")[0].split("{")[0]):
                return []
        elif what == kind.VAR_DECL:
            return self.mutate_variable(cursor, children)
        elif what in (kind.BINARY_OPERATOR, kind.CALL_EXPR):
            self.mutate_operator(cursor)
            if what == kind.CALL_EXPR:
                self.swap_arguments(cursor, parent)
        elif what in (kind.INTEGER_LITERAL, kind.FLOATING_LITERAL, kind.CXX_BOOL_LITERAL_EXPR, kind.DECL_REF_EXPR):
            self.replace_constant(cursor, parent)
        return children

    def condition_of(self, cursor, children):
        """The last child inside the parentheses that follow the keyword, and their text."""
        start = cursor.extent.start.offset
        at = self.text.find("(", start)
        depth, end = 0, at
        for end in range(at, len(self.text)):
            depth += {"(": 1, ")": -1}.get(self.text[end], 0)
            if depth == 0:
                break
        inside = [each for each in children if self.is_here(each) and at < each.extent.start.offset and
                  each.extent.end.offset <= end]
        return inside, self.text[at + 1:end]

    def mutate_if(self, cursor, children):
        inside, text = self.condition_of(cursor, children)
        branches = [each for each in children if each not in inside]
        if re.match(r"if\s+constexpr\b", self.text_of(cursor)):
            self.leave_out(branches)
            return branches
        declared = [each for each in inside if each.kind in (kind.VAR_DECL, kind.DECL_STMT)]
        if inside and ";" not in text and declared:
            variable = declared[0]
            name = variable.spelling or next((each.spelling for each in variable.get_children()), "")
            start, end = variable.extent.start.offset, variable.extent.end.offset
            is_bool = variable.type.get_canonical().kind == TypeKind.BOOL  # its value is negated
            if re.fullmatch(r"\w+", name) and not is_bool:
                self.add("condition negated", start, end, f"{self.text_of(variable)} -> ! of it", "declaration", name)
        elif inside and inside[-1].kind not in (kind.VAR_DECL, kind.DECL_STMT):
            self.negate(inside[-1])
        self.leave_out(branches)
        return children

    def mutate_loop(self, cursor, children):
        body = children[-1:] if cursor.kind != kind.DO_STMT else children[:1]
        self.leave_out(body)
        if cursor.kind == kind.FOR_STMT:
            head, text = self.condition_of(cursor, children)
            semicolons = [at for at in range(len(text)) if text[at] == ";"]
            if len(semicolons) == 2:
                base = self.text.find("(", cursor.extent.start.offset) + 1
                for each in head:
                    if base + semicolons[0] < each.extent.start.offset < base + semicolons[1]:
                        self.negate(each)
        elif cursor.kind == kind.WHILE_STMT:
            head, _ = self.condition_of(cursor, children)
            if head and head[-1].kind not in (kind.VAR_DECL, kind.DECL_STMT):
                self.negate(head[-1])
        elif cursor.kind == kind.DO_STMT and len(children) == 2:
            self.negate(children[1])

    def operator_of(self, cursor):
        """Left side, operator and right side of a comparison or a logical operation."""
        children = [each for each in cursor.get_children() if self.is_here(each)]
        if cursor.kind == kind.CALL_EXPR and not cursor.spelling.startswith("operator"):
            return None
        if len(children) < 2:
            return None
        left, right = children[0], children[-1]
        if left.extent.end.offset > right.extent.start.offset:
            return None
        between = without_comments(self.text[left.extent.end.offset:right.extent.start.offset])
        return left, between, right

    def plain(self, cursor):
        """The node below implicit conversions."""
        while cursor.kind in (kind.UNEXPOSED_EXPR, kind.UNARY_OPERATOR):  # a != b may be the unary !(a == b)
            children = list(cursor.get_children())
            if len(children) != 1 or children[0].extent != cursor.extent:
                break
            cursor = children[0]
        return cursor

    def is_equality(self, cursor):
        found = self.operator_of(self.plain(cursor))
        return found is not None and found[1] in ("==", "!=")

    def negate(self, cursor):
        if not self.is_here(cursor) or self.is_equality(cursor) or self.plain(cursor).kind == kind.CXX_BOOL_LITERAL_EXPR:
            return
        text = self.text_of(cursor)
        negated = text[1:] if re.fullmatch(r"!\w+", text) else f"!({text})"
        self.add("condition negated", cursor.extent.start.offset, cursor.extent.end.offset, f"{text} -> {negated}", "condition",
                 negated)

    def mutate_operator(self, cursor):
        found = self.operator_of(cursor)
        if found is None:
            return
        left, name, right = found
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        if name in shifted:
            text = f"{self.text_of(left)} {shifted[name]} {self.text_of(right)}"
            self.add("comparison shifted", start, end, f"{self.text_of(cursor)} -> {text}", "value", text)
        if name in ("&&", "||"):
            for each in (left, right):
                inner = self.operator_of(self.plain(each))
                if inner is not None and inner[1] == name:
                    continue
                self.add("operand left out", each.extent.start.offset, each.extent.end.offset,
                         f"{self.text_of(each)} -> left out of {name}", "condition", "true" if name == "&&" else "false")

    def swap_arguments(self, cursor, parent):
        if cursor.spelling.startswith("operator") or cursor.spelling in ("min", "max") or not self.is_here(cursor):
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        is_variable = parent is not None and parent.kind == kind.VAR_DECL and parent.location.offset == start
        if self.text[start] == "{" or is_variable:
            return
        arguments = [each for each in cursor.get_arguments() if each is not None and self.is_here(each)]
        for first, second in zip(arguments, arguments[1:]):
            types = [self.plain(each).type.get_canonical().spelling.replace("const ", "") for each in (first, second)]
            texts = self.text_of(first), self.text_of(second)
            a, b = first.extent, second.extent
            is_in_order = start <= a.start.offset and a.end.offset <= b.start.offset and b.end.offset <= end
            if types[0] != types[1] or types[0] in ("", "<dependent type>") or texts[0] == texts[1] or not is_in_order:
                continue
            text = (self.text[start:a.start.offset] + texts[1] + self.text[a.end.offset:b.start.offset] + texts[0] +
                    self.text[b.end.offset:end])
            self.add("arguments swapped", start, end, f"{self.text_of(cursor)} -> {text}", "value", text)

    def replace_constant(self, cursor, parent):
        start, end, text = cursor.extent.start.offset, cursor.extent.end.offset, self.text_of(cursor)
        new = None
        if cursor.kind == kind.CXX_BOOL_LITERAL_EXPR:
            new = {"true": "false", "false": "true"}.get(text)
        elif cursor.kind == kind.INTEGER_LITERAL and re.fullmatch(r"(0x[0-9a-fA-F']+|[0-9']+)[uUlLzZ]*", text):
            new = f"{text} + 1"
        elif cursor.kind == kind.FLOATING_LITERAL and re.fullmatch(r"[0-9.'e+-]+[fFlL]?", text):
            new = f"{text} + 1" if float(re.sub("[fFlL']", "", text)) == 0 else f"2 * {text}"
        elif cursor.kind == kind.DECL_REF_EXPR and cursor.referenced is not None:
            target = cursor.referenced
            if target.kind == kind.ENUM_CONSTANT_DECL:
                new = self.other_enumerator(target, text)
            elif target.kind == kind.VAR_DECL and target.semantic_parent.kind in (kind.NAMESPACE, kind.CLASS_DECL, kind.STRUCT_DECL):
                is_integer = target.type.get_canonical().kind in integers and target.type.is_const_qualified()
                new = f"{text} + 1" if is_integer and re.fullmatch(r"[\w:]+", text) else None
        if new is None:
            return
        change = f"{text} -> {new}"
        # A value in braces must keep the type that it is converted to.
        form = "value"
        if parent is not None and parent.kind == kind.UNEXPOSED_EXPR and parent.extent == cursor.extent:
            wanted = parent.type.get_canonical()
            if wanted.kind in arithmetic and cursor.type.get_canonical().kind in arithmetic:
                form = f"cast {wanted.spelling.replace('const ', '')}"
        self.add("constant replaced", start, end, change, form, new)

    @staticmethod
    def other_enumerator(target, text):
        all_of_it = [each for each in target.semantic_parent.get_children() if each.kind == kind.ENUM_CONSTANT_DECL]
        names = [each.spelling for each in all_of_it]
        position = names.index(target.spelling)
        for step in range(1, len(names)):
            other = all_of_it[(position + step) % len(names)]
            if other.enum_value != target.enum_value and text.endswith(target.spelling):
                return text[:len(text) - len(target.spelling)] + other.spelling
        return None

    def mutate_return(self, cursor, value, in_lambda):
        if not self.is_here(value):
            return
        text = self.text_of(value)
        start, end = cursor.extent.start.offset, self.end_of_statement(cursor)
        base = self.plain(value)
        returned = value.type.get_canonical().kind
        if end is None or base.kind in (kind.INTEGER_LITERAL, kind.FLOATING_LITERAL, kind.CXX_BOOL_LITERAL_EXPR):
            return
        if returned == TypeKind.BOOL:
            if not self.is_equality(value):
                negated = text[1:] if re.fullmatch(r"!\w+", text) else f"!({text})"
                self.add("return exchanged", value.extent.start.offset, value.extent.end.offset,
                         f"return {text} -> return {negated}", "condition", negated)
            return
        if returned == TypeKind.VOID or text in ("{}", "nullptr", "std::nullopt", "*this"):
            return
        if base.kind == kind.DECL_REF_EXPR and base.referenced and base.referenced.kind == kind.ENUM_CONSTANT_DECL:
            return  # replaced as a constant
        nothing = f"decltype({text}){{}}" if in_lambda and text[0] != "{" else "{}"
        self.add("return exchanged", start, end, f"return {text} -> return {{}}", "return", f"return {nothing};")

    def mutate_variable(self, cursor, children):
        text = self.text_of(cursor)
        if re.search(r"\bconstexpr\b", text.split("=")[0]):
            return []
        if cursor.type.is_const_qualified() and not self.depends(cursor):
            return []  # a constant expression, which is never switched
        if cursor.type.get_canonical().kind == TypeKind.BOOL and children and "=" in text and children[-1].kind.is_expression():
            self.negate(children[-1])
        return children

    def depends(self, cursor):
        """Whether the initial value depends on a variable, a function or this object."""
        for each in cursor.walk_preorder():
            if each.kind in (kind.CALL_EXPR, kind.MEMBER_REF_EXPR, kind.CXX_THIS_EXPR, kind.LAMBDA_EXPR):
                return True
            if each.kind == kind.DECL_REF_EXPR and (each.referenced is None or each.referenced.kind != kind.ENUM_CONSTANT_DECL):
                return True
        return False

    def end_of_statement(self, cursor):
        found = re.compile(r"\s*;").match(self.text, cursor.extent.end.offset)
        return found.end() if found else None

    def keep_last_break(self, cursor):
        """The last break of a switch changes nothing."""
        while cursor.kind in (kind.CASE_STMT, kind.DEFAULT_STMT):
            cursor = list(cursor.get_children())[-1]
        if cursor.kind == kind.BREAK_STMT:
            self.kept.add(cursor.extent.start.offset)

    def leave_out(self, statements):
        for each in statements:
            if each.extent.start.offset in self.kept:
                continue
            is_jump = each.kind in (kind.BREAK_STMT, kind.CONTINUE_STMT, kind.RETURN_STMT) and not list(each.get_children())
            if not self.is_here(each) or not (is_jump or each.kind.is_expression()):
                continue
            text, end = self.text_of(each), self.end_of_statement(each)
            if end is None or re.fullmatch(r"static_cast<void>\(\w+\)", text):
                continue
            self.add("statement left out", each.extent.start.offset, end, f"{text}; -> left out", "statement", "")


def parse(tree, headers, options=()):
    """One unit with these headers, relative to the include folder."""
    unit = "".join(f"#include <{name}>\n" for name in headers)
    arguments = ["-std=c++20", f"-I{tree}/include", f"-I{tree}/schemas", "-ferror-limit=0", "-w", *options]
    return cindex.Index.create().parse("unit.cpp", arguments, [("unit.cpp", unit)])


def files_of(tree, module, folder="include/jauscat"):
    """Headers and bodies in the folder of a module."""
    top = pathlib.Path(tree) / folder / module
    return sorted(str(path.relative_to(tree)) for path in top.rglob("*.[hi]pp"))


def find(tree, module, folder="include/jauscat"):
    """All mutants of a module, in the order of files and bytes."""
    names = files_of(tree, module, folder)
    headers = [name.removeprefix("include/") for name in names if name.endswith(".hpp")]
    unit = parse(tree, headers)
    wrong = [each for each in unit.diagnostics if each.severity >= cindex.Diagnostic.Error]
    if wrong:
        raise RuntimeError(f"{module} does not parse: {wrong[0]}")
    finders = {name: finder(module, name, (pathlib.Path(tree) / name).read_bytes().decode("latin-1")) for name in names}
    for cursor in unit.cursor.get_children():
        place = cursor.location.file
        name = place.name.removeprefix(f"{tree}/") if place else None
        if name in finders:
            finders[name].walk(cursor, None, False, False)
    found = [each for name in names for each in finders[name].found.values()]
    return sorted(found, key=lambda each: (each.file, each.start, -each.end, each.kind, each.change))


class rendered:
    """The text of a file with its mutants, and which mutant each byte belongs to."""

    def __init__(self, text, mutants):
        self.pieces, self.source = [], text
        self.rejected = []
        ordered = sorted(mutants, key=lambda each: (each.start, -each.end, each.form != "return" and each.form != "statement"))
        # Warnings of the compiler concern the code as it is written, not its mutants.
        self.put("#pragma GCC system_header\n#include <mutant_switch.hpp>\n", None)
        self.range(0, len(text), ordered, None)
        self.text = "".join(piece for piece, _ in self.pieces)
        self.ends, total = [], 0
        for piece, _ in self.pieces:
            total += len(piece)
            self.ends.append(total)

    def put(self, text, owner):
        if text:
            self.pieces.append((text, owner))

    def range(self, start, end, mutants, owner):
        at, rest = start, list(mutants)
        while rest:
            first = rest.pop(0)
            if first.start < at or first.end > end:
                self.rejected.append(first)
                continue
            inner = [each for each in rest if each.start < first.end]
            rest = rest[len(inner):]
            self.put(self.source[at:first.start], owner)
            self.wrap(first, inner)
            at = first.end
        self.put(self.source[at:end], owner)

    def wrap(self, one, inner):
        is_it = f"::mutant_switch::is({one.number})"
        before, after = {
            "value": (f"({is_it} ? ({one.text}) : (", "))"),
            "condition": (f"({is_it} ? static_cast<bool>({one.text}) : static_cast<bool>(", "))"),
            "statement": (f"{{ if (!{is_it}) {{ ", " } }"),
            "return": (f"{{ if ({is_it}) {one.text} ", " }"),
            "declaration": ("", f"; ({is_it} ? !{one.text} : static_cast<bool>({one.text}))"),
        }.get(one.form, (f"static_cast<{one.form.removeprefix('cast ')}>({is_it} ? ({one.text}) : (", "))"))
        self.put(before, one)
        self.range(one.start, one.end, inner, one)
        self.put(after, one)

    def owner(self, line, column):
        """The innermost mutant at this place of the new text; its numbers count from 1."""
        starts = [0] + [at.end() for at in re.finditer("\n", self.text)]
        if line > len(starts):
            return None
        offset = starts[line - 1] + column - 1
        position = min(bisect.bisect_right(self.ends, offset), len(self.pieces) - 1)
        return self.pieces[position][1]


def file_of(files, path):
    """The one of these names that a compiler writes as this path."""
    return next((name for name in files if f"/{path}".endswith("/" + name)), None)


def owner_at(files, path, line, column):
    name = file_of(files, path)
    return files[name].owner(line, column) if name else None


def refused(tree, headers, files, options=()):
    """The mutants that clang refuses in the mutated tree; files: rendered texts by name. Errors elsewhere are returned, too."""
    bad, other = {}, []
    for each in parse(tree, headers, options).diagnostics:
        if each.severity < cindex.Diagnostic.Error:
            continue
        # Where a template of another file cannot be instantiated, notes say what uses it.
        places = [each.location] if file_of(files, each.location.file) else [note.location for note in each.children]
        owner = next(filter(None, (owner_at(files, at.file, at.line, at.column) for at in places)), None)
        if owner is None:
            other.append(str(each))
        else:
            bad[owner.number] = owner
    return list(bad.values()), other
