# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sentence is English text everywhere, and can be said in another language anywhere."""

import copy
import json

from gpswb.errors import InputError
from gpswb.sentence import Sentence, joined, packed, unpacked

WORDS = {
    "{size:.3g} mm of {what}": "von {what} {size:.3g} mm",
    "the {thing} {name!r}": "das {thing} {name!r}",
    "hole": "Loch",
}


def german(template):
    return WORDS.get(template, template)


def example():
    # What the user has typed may look like a field: it is a value, never a template.
    return Sentence(
        "{size:.3g} mm of {what}",
        size=1.23456,
        what=Sentence("the {thing} {name!r}", thing=Sentence("hole"), name="{size}"),
    )


ENGLISH = "1.23 mm of the hole '{size}'"
GERMAN = "von das Loch '{size}' 1.23 mm"


def test_it_is_plain_text_to_everybody_else():
    assert example() == ENGLISH
    assert {example(): 1}[ENGLISH] == 1
    assert json.dumps([example()]) == json.dumps([ENGLISH])
    assert f"{example()}!" == ENGLISH + "!"


def test_it_is_said_in_another_language_from_the_inside_out():
    assert example().said(german) == GERMAN
    assert example().said(lambda template: template) == ENGLISH
    assert joined("; ", [example(), "Face1"]).said(german) == f"{GERMAN}; Face1"
    assert joined("; ", []) == ""


def test_it_comes_through_errors_copies_and_other_processes():
    error = str(InputError(example()))
    through = (
        error,
        copy.deepcopy(example()),
        copy.copy(example()),
        unpacked(json.loads(json.dumps(packed(example())))),
    )
    for text in through:
        assert isinstance(text, Sentence)
        assert text == ENGLISH
        assert text.said(german) == GERMAN
    assert unpacked(json.loads(json.dumps(packed("plain {text}")))) == "plain {text}"
