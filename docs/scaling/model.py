"""The model of docs/scaling.md: prints its tables.

    python docs/scaling/model.py

Seconds of one sweep on one of P ranks with n = N / P spheres in a cube, n^(2/3) of them on each face:

    compute   n c t_u                       contacts of a sphere times time of an update
    halo      3 a + 6 n^(2/3) G / B         three exchanges, one along each axis, of G bytes a ghost
    stop      a ceil(log2 P) / k            one reduction every k sweeps

and efficiency = compute / ((compute + halo + stop) f): f is what splitting adds in sweeps.
"""

from math import ceil, log2

CONTACTS = 2.5  # rows of a sphere
LATENCY, BANDWIDTH = 1.5e-6, 12.5e9  # [s], [B/s]: 100 Gb/s
GHOST = 6 * 8  # [B]: an increment of velocity and spin
SWEEPS_A_TEST = 4
SIZES = [10**6, 10**7, 10**8, 10**9]
RANKS = [1, 2, 8, 32, 128, 512, 1024]
FEWEST = 1000  # spheres a rank below which a row is left out


def sweep(size, ranks, update, sharing=1):
    """Seconds of a sweep: computing, exchanging, testing. `sharing` ranks of a node share its link."""
    n = size / ranks
    compute = n * CONTACTS * update
    if ranks == 1:
        return compute, 0.0, 0.0
    # What leaves a node is the surface of the block of all its ranks, over one link.
    block = n * min(sharing, ranks)
    leaves = 6 * block ** (2 / 3) if ranks > sharing else 0.0
    halo = 3 * LATENCY + leaves * GHOST / BANDWIDTH
    return compute, halo, LATENCY * ceil(log2(ranks)) / SWEEPS_A_TEST


def efficiency(*arguments, factor=1.0):
    """Share of the time that computes what one rank would have computed."""
    compute, halo, stop = sweep(*arguments)
    return compute / ((compute + halo + stop) * factor)


def table(update, sharing):
    print(f"update {update * 1e9:.0f} ns, {sharing} rank(s) on a link: efficiency [%] and time of a sweep")
    print("| spheres | " + " | ".join(f"{ranks}" for ranks in RANKS) + " |")
    print("|---" * (len(RANKS) + 1) + "|")
    for size in SIZES:
        cells = []
        for ranks in RANKS:
            seconds = sum(sweep(size, ranks, update, sharing))
            scaled = f"{seconds * 1e3:.3g} ms"
            cells.append(f"{100 * efficiency(size, ranks, update, sharing):.0f}, {scaled}" if size / ranks >= FEWEST else "")
        print(f"| 10^{round(log2(size) / log2(10))} | " + " | ".join(cells) + " |")
    print()


if __name__ == "__main__":
    for update, sharing in [(13e-9, 1), (3e-9, 1), (3e-9, 32)]:
        table(update, sharing)
