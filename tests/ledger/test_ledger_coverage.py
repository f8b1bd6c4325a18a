"""Every statement of every source has its row; the lists beside this file were made from the sources, not the rows."""

from importlib import import_module

import pytest

from bezteach import ledger

LISTS = {source: import_module(f"statements_{source}").STATEMENTS for source in ledger.READINGS}


@pytest.mark.parametrize("source", LISTS)
def test_every_statement_has_a_row_and_every_row_a_statement(source):
    places = [row.place for row in ledger.READINGS[source]]
    listed = [place for _, found in LISTS[source] for place in found]
    assert all(found for _, found in LISTS[source])
    assert set(listed) - set(places) == set(), "no row"
    assert set(places) - set(listed) == set(), "no statement"


@pytest.mark.parametrize("source", LISTS)
def test_the_rows_come_in_the_order_of_the_statements(source):
    order = {row.place: number for number, row in enumerate(ledger.READINGS[source])}
    first = [min(order[place] for place in found) for _, found in LISTS[source]]
    assert first == sorted(first)
