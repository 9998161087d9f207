# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entities of a Part 21 text: nothing in a string or a comment is taken for structure."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gpswb.errors import InputError
from gpswb.io.ap242.part21 import Part21, Ref, Typed, Word
from gpswb.io.ap242.strings import decode, encode
from gpswb.io.ap242.write import appended

HEAD = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('X'));\nENDSEC;\nDATA;\n"
TAIL = "ENDSEC;\nEND-ISO-10303-21;\n"


def part21(*lines: str) -> Part21:
    return Part21(HEAD + "\n".join(lines) + "\n" + TAIL)


@given(st.text())
def test_any_text_survives_as_a_literal(text: str) -> None:
    literal = encode(text)
    assert literal.isascii()
    assert literal[1:-1].isprintable() or not text
    assert decode(literal[1:-1]) == text
    assert part21(f"#1=NAME({literal},#2);")[1] == {"NAME": (text, Ref(2))}


@pytest.mark.parametrize(
    ("literal", "text"),
    [
        (r"\X2\03C600E4\X0\x", "φäx"),
        (r"\X4\0001F529\X0\ ", "🔩 "),
        (r"\X\E4", "ä"),
        (r"\S\d", "ä"),  # ISO 8859-1: d is 0x64, ä is 0xE4
        (r"C:\\temp", r"C:\temp"),
        ("it''s", "it's"),
        (r"\X2\D83D\X0\ ", "\ufffd "),  # half a surrogate pair
        (r"\Q\ left alone", r"\Q\ left alone"),
    ],
)
def test_directives(literal: str, text: str) -> None:
    assert decode(literal) == text


def test_structure_in_strings_and_comments_is_none() -> None:
    file = part21(
        "#1=A('#9=B(); ENDSEC;','/* no comment','it''s (',$,*);",
        "/* #7=GONE(); ' ; ENDSEC; */ #2 /* ! */ = /* ; */ B ( 'x''' , (1,2.5,-3.E-2) ) ;",
        '#3=C(LENGTH_MEASURE(25.4),.T.,"0AF",((#1),()));',
    )
    assert 7 not in file
    assert 9 not in file
    assert file[1] == {
        "A": ("#9=B(); ENDSEC;", "/* no comment", "it's (", None, Word("*")),
    }
    assert file[2] == {"B": ("x'", (1, 2.5, -0.03))}
    assert file[3]["C"][0] == Typed("LENGTH_MEASURE", (25.4,))
    assert file[3]["C"][1:] == ("T", "0AF", ((Ref(1),), ()))
    assert list(file.of("B")) == [2]


def test_complex_entities_are_found_under_each_keyword() -> None:
    file = part21("#5=(\nLENGTH_UNIT()\nNAMED_UNIT(*)\nSI_UNIT(.MILLI.,.METRE.)\n);")
    assert list(file.of("SI_UNIT")) == list(file.of("LENGTH_UNIT")) == [5]
    assert file.get(Ref(5), "SI_UNIT") == ("MILLI", "METRE")
    assert file.get(Ref(5), "OTHER") is None
    assert file.get(Ref(6), "SI_UNIT") is None


@pytest.mark.parametrize(
    "body",
    ["A('open", "A(1,2", "A((1)", "A)", "A(" + "(" * 100 + ")" * 100 + ")", "A(@)"],
)
def test_malformed_entities_are_an_input_error_when_asked_for(body: str) -> None:
    with pytest.raises(InputError):
        _ = part21(f"#1={body};", "#2=FINE();")[1]


def test_malformed_entities_that_nobody_asks_for_do_no_harm() -> None:
    file = part21("#1=(A(;", "#2=FINE(#1);")
    assert list(file.of("FINE")) == [2]
    with pytest.raises(InputError, match="#1"):
        _ = file[1]


@pytest.mark.parametrize("text", ["", "solid cube", HEAD, "DATA;\nENDSEC;\n"])
def test_other_files_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="not a STEP file"):
        Part21(text)


def test_a_comment_may_come_first() -> None:
    assert Part21("/* ISO; */\n" + HEAD + "#1=A();\n" + TAIL).highest == 1


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_what_is_appended_leaves_the_rest_as_it_was(newline: str) -> None:
    text = (HEAD + "#12=A('ENDSEC;');\n" + TAIL).replace("\n", newline)
    done = appended(Part21(text), ["#13=B();", "#14=C();"])
    lines = done.split(newline)
    assert lines[5:8] == ["#12=A('ENDSEC;');", "#13=B();", "#14=C();"]
    without = [line for line in lines if line not in ("#13=B();", "#14=C();")]
    assert without[:2] + without[3:] == text.split(newline)[:2] + text.split(newline)[3:]
    assert "AP242" in without[2]


def test_a_schema_of_ap242_is_kept() -> None:
    schema = "FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF. {1 0}'));"
    text = HEAD.replace("FILE_SCHEMA(('X'));", schema) + TAIL
    assert schema in appended(Part21(text), ["#1=A();"])
