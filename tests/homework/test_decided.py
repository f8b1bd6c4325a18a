"""The table of what the checker decides is made of its verdicts, and shows all of them."""

from bezteach.homework import CORRECT, INVALID, OPEN, PARTLY, WRONG
from bezteach.homework.decided import PLACE, page


def test_the_table_is_up_to_date():
    """If not: python -m bezteach.homework.decided."""
    assert PLACE.read_text(encoding="utf-8") == page()


def test_it_has_each_verdict():
    rows = [line for line in page().splitlines() if line.startswith("| ")][1:]
    assert len(rows) > 40 and all(line.count(" | ") == 3 for line in rows)
    for status in (CORRECT, PARTLY, WRONG, INVALID, OPEN):
        assert any(f"| {status} |" in line for line in rows)
