"""The figures of each run, in a file."""

import contextlib
import csv

from odometry_sweep.figures import FIGURES

FILE = 'runs.csv'
CAMPAIGN_FILE = 'campaign.yaml'


@contextlib.contextmanager
def written_results(folder, campaign):
    """Write a campaign into a folder; yield a function that writes the next of its runs.

    It takes parameters and figures by their names; the row is in the file when it returns.
    """
    (folder / CAMPAIGN_FILE).write_text(campaign.text(), encoding='utf-8')
    with open(folder / FILE, 'w', newline='', encoding='utf-8', buffering=1) as file:
        rows = csv.DictWriter(file, ['run', *campaign.values, 'seed', *FIGURES[campaign.tutorial],
                                     'ended'], lineterminator='\n')
        rows.writeheader()
        count = 0

        def write(parameters, figures):
            nonlocal count
            count += 1
            rows.writerow({'run': count, **parameters, **figures})

        yield write


def count_written(folder):
    """Return how many runs are in the file of a folder; 0 without a file."""
    if not (folder / FILE).exists():
        return 0
    with open(folder / FILE, newline='', encoding='utf-8') as file:
        return sum(1 for _ in csv.DictReader(file))
