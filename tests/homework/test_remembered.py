"""What is decided once is not asked for again; what is not, is."""

from bezteach.homework import remembered
from bezteach.symbolic import B, i, n, t


def counted(monkeypatch, name):
    """How often the prover is asked, as a list that grows."""
    asked, ask = [], getattr(remembered, name)
    monkeypatch.setattr(remembered, name, lambda *a, **k: asked.append(a) or ask(*a, **k))
    return asked


def test_a_proof_is_asked_for_once(monkeypatch):
    asked = counted(monkeypatch, "prove")
    for _ in range(2):
        assert remembered.proved(7 * t * B(i, n, t), t * B(i, n, t) * 7, {i: (0, n)}, 5.0).status == "PROVED"
        assert remembered.proved(7 * t * B(i, n, t), t * B(i, n, t) * 8, {i: (0, n)}, 5.0).status == "REFUTED"
    assert len(asked) == 2


def test_other_ranges_are_another_question(monkeypatch):
    asked = counted(monkeypatch, "prove")
    remembered.proved(t * B(i, n, t) / 7, B(i, n, t) * t / 7, {i: (0, n)}, 5.0)
    remembered.proved(t * B(i, n, t) / 7, B(i, n, t) * t / 7, {i: (1, n)}, 5.0)
    assert len(asked) == 2


def test_what_had_no_time_is_tried_again(monkeypatch):
    asked = counted(monkeypatch, "check_derivation")
    lines = [t * B(i, n, t), (i + 1) / (n + 1) * B(i + 1, n + 1, t)]
    assert remembered.derived(lines, {i: (0, n)}, 0.0).status not in ("PROVED", "REFUTED")
    assert remembered.derived(lines, {i: (0, n)}, 0.0).status not in ("PROVED", "REFUTED")
    assert remembered.derived(lines, {i: (0, n)}, 9.0).status == "PROVED"
    assert remembered.derived(lines, {i: (0, n)}, 9.0).status == "PROVED"
    assert len(asked) == 3
