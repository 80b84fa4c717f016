"""Seeds: nobody can find one by trying, and the inputs of one check tell nothing of another's."""

from tam570_grader.grading.seeds import BITS, derive, new_seed, seed


def test_a_seed_has_all_its_bits():
    seeds = {new_seed() for _ in range(100)}
    assert len(seeds) == 100 and 2 ** (BITS - 12) < max(seeds) < 2**BITS
    assert seed(None, [], None) != seed(None, [], None) and seed(570, [], None) == 570


def test_what_is_derived_depends_on_every_name_and_on_the_whole_secret():
    derived = [
        derive(1, "hw07", "a"),
        derive(2, "hw07", "a"),
        derive(1 + 2**127, "hw07", "a"),
        derive(b"key", "hw07", "a"),
    ]
    derived += [derive(1, "hw08", "a"), derive(1, "hw07", "b"), derive(1, "hw07a", ""), derive(1, "hw07", "a", "")]
    assert len(set(derived)) == len(derived) and max(derived) < 2**BITS
    assert derive(1, "hw07", "a") == derived[0]
