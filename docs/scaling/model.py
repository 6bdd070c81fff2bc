"""The model of docs/scaling.md: prints its tables.

    python docs/scaling/model.py

Seconds of one sweep on one of P ranks with n = N / P spheres in a cube, n^(2/3) of them on each face:

    compute   n c t_u                       contacts of a sphere times time of an update
    halo      m a + 6 n^(2/3) G / B         border last: m = 13 directions, G bytes a sphere at the border
    twice     3 n^(2/3) t_u                 contacts across a face, one a sphere there, are computed by both sides
    stop      a ceil(log2 P) / k            one reduction every k sweeps

and efficiency = compute / (compute + halo + twice + stop). Border last adds no sweeps.
"""

from math import ceil, log2

CONTACTS = 2.5  # rows of a sphere
LATENCY, BANDWIDTH = 1.5e-6, 12.5e9  # [s], [B/s]: 100 Gb/s
GHOST = 6 * 8  # [B]: velocity and spin
DIRECTIONS = 13
SWEEPS_A_TEST = 4
SIZES = [10**6, 10**7, 10**8, 10**9]
RANKS = [1, 2, 8, 32, 128, 512, 1024]
FEWEST = 1000  # spheres a rank below which a row is left out


def sweep(size, ranks, update, sharing=1):
    """Seconds of a sweep: computing, exchanging, computing twice, testing. `sharing` ranks of a node share its link."""
    n = size / ranks
    compute = n * CONTACTS * update
    if ranks == 1:
        return compute, 0.0, 0.0, 0.0
    # What leaves a node is the surface of the block of all its ranks, over one link.
    block = n * min(sharing, ranks)
    leaves = 6 * block ** (2 / 3) if ranks > sharing else 0.0
    halo = DIRECTIONS * LATENCY + leaves * GHOST / BANDWIDTH
    return compute, halo, 3 * n ** (2 / 3) * update, LATENCY * ceil(log2(ranks)) / SWEEPS_A_TEST


def efficiency(*arguments):
    """Share of the time that computes what one rank would have computed."""
    parts = sweep(*arguments)
    return parts[0] / sum(parts)


def readable(seconds):
    """Two digits and a unit."""
    unit, scale = ("s", 1) if seconds >= 1 else ("ms", 1e3) if seconds >= 1e-3 else ("us", 1e6)
    return f"{float(f'{seconds * scale:.2g}'):g} {unit}"


def table(update, sharing):
    print(f"Update {update * 1e9:.0f} ns, {sharing} {'rank' if sharing == 1 else 'ranks'} on a link:\n")
    print("| spheres, ranks | " + " | ".join(f"{ranks}" for ranks in RANKS) + " |")
    print("|---" * (len(RANKS) + 1) + "|")
    for size in SIZES:
        cells = []
        for ranks in RANKS:
            seconds = sum(sweep(size, ranks, update, sharing))
            share = efficiency(size, ranks, update, sharing)
            cells.append(f"{100 * share:.0f} %, {readable(seconds)}" if size / ranks >= FEWEST else "")
        print(f"| 10^{round(log2(size) / log2(10))} | " + " | ".join(cells) + " |")
    print()


if __name__ == "__main__":
    for update, sharing in [(13e-9, 1), (3e-9, 1), (3e-9, 32)]:
        table(update, sharing)
