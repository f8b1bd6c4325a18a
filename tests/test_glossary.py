"""The glossary and the lessons have the same terms."""

import re

import pytest

from bezteach import glossary

PROSE = glossary._prose()


@pytest.mark.parametrize("term", glossary.TERMS)
def test_each_term_of_the_glossary_is_in_a_lesson(term):
    assert any(glossary.TERMS[term] in text for text in PROSE.values())


@pytest.mark.parametrize("lesson", PROSE)
def test_each_term_in_parentheses_in_a_lesson_is_in_the_glossary(lesson):
    brackets = re.findall(r"\(([^()]*[\u4e00-\u9fff][^()]*)\)", PROSE[lesson])
    words = {word for inside in brackets for word in re.findall(r"[\u4e00-\u9fff]+", inside)}
    known = set(glossary.TERMS.values()) | {"规范性", "最小二乘法", "次"}  # other names of the same
    assert words - known == set()


def test_the_table_names_the_first_lesson():
    text = glossary.table().text
    assert "control point: 控制顶点 (01)" in text and "hodograph: 速端曲线 (07)" in text


def test_the_terms_come_in_the_order_of_the_lessons():
    lessons = re.findall(r"\((\d\d)\)$", glossary.table().text, flags=re.M)
    assert lessons == sorted(lessons) and len(lessons) == len(glossary.TERMS)
