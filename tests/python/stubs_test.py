"""The stub and the module have the same names, parameters and defaults."""
import ast
import inspect
import pathlib
import re

import jauscat

tree = ast.parse((pathlib.Path(jauscat.__file__).parent / "__init__.pyi").read_text())


def parameters(function):
    """(name, whether it has a default) of a stub's function, without self."""
    arguments = function.args
    plain = arguments.posonlyargs + arguments.args
    named = [(one.arg, i >= len(plain) - len(arguments.defaults)) for i, one in enumerate(plain)]
    named += [(one.arg, default is not None) for one, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return [one for one in named if one[0] != "self"]


def parameters_of(function):
    """The same of a function of the module: the first line of its documentation is its signature."""
    inside = re.match(r"\w+\((.*)\) -> ", function.__doc__.split("\n")[0])[1]
    inside = re.sub(r"<[^>]*>|\[[^\]]*\]|'[^']*'|\{[^}]*\}", "x", inside)
    parts = [part.strip() for part in inside.split(",")]
    return [(part.partition(":")[0], "=" in part) for part in parts if part not in ("", "*") and not part.startswith("self")]


def names_of(scope):
    return {name for name in vars(scope) if not name.startswith("_")}


def test_every_name_of_the_module_is_in_the_stub_and_the_reverse():
    stub = {one.name for one in tree.body if isinstance(one, (ast.ClassDef, ast.FunctionDef))}
    assert stub == names_of(jauscat)


def test_classes_have_the_same_members_with_the_same_parameters():
    for one in tree.body:
        if not isinstance(one, ast.ClassDef):
            continue
        real = getattr(jauscat, one.name)
        members = {each.name: each for each in one.body if isinstance(each, ast.FunctionDef)}
        if issubclass(real, Exception):
            assert [base.id for base in one.bases] == [real.__base__.__name__]
            continue
        assert {name for name in members if not name.startswith("_")} == names_of(real), one.name
        for name, member in members.items():
            is_property = any(getattr(each, "id", "") == "property" for each in member.decorator_list)
            assert isinstance(getattr(real, name), property) == is_property, f"{one.name}.{name}"
            if not is_property and name != "__exit__":
                assert parameters(member) == parameters_of(getattr(real, name)), f"{one.name}.{name}"


def test_functions_have_the_same_parameters():
    for one in tree.body:
        if isinstance(one, ast.FunctionDef):
            assert parameters(one) == parameters_of(getattr(jauscat, one.name)), one.name


def test_what_the_declaration_does_not_say_is_documented():
    for name in names_of(jauscat):
        assert len(inspect.getdoc(getattr(jauscat, name)).split("\n")) > 0, name
        assert inspect.getdoc(getattr(jauscat, name)).strip(), name
