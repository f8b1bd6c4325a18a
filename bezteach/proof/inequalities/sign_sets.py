"""Sets of signs out of -1, 0, 1, and those of a product and of a sum of parts with such signs."""

ANY, ZERO, POSITIVE, NOT_NEGATIVE = map(frozenset, ((-1, 0, 1), (0,), (1,), (0, 1)))


def product(*factors):
    result = POSITIVE
    for factor in factors:
        result = frozenset(one * other for one in result for other in factor)
    return result


def total(terms):
    result = ZERO
    for term in terms:
        pairs = [(one, other) for one in result for other in term]
        result = ANY if any(one * other < 0 for one, other in pairs) else frozenset(a or b for a, b in pairs)
    return result
