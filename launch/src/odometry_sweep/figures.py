"""What is said of a run, with its unit; an error is what is, minus what should be."""

FIGURES = {
    'move': {'moved': 'm', 'moved_error': 'm', 'true_distance': 'm', 'true_error': 'm',
             'sideways': 'm', 'heading': 'degrees', 'time': 's'},
    'rotate': {'heading': 'degrees', 'heading_error': 'degrees', 'true_heading': 'degrees',
               'true_error': 'degrees', 'overshoot': 'degrees', 'time': 's'}}
# Of these the table has statistics.
JUDGED = {'move': ['moved_error', 'true_error', 'sideways', 'heading', 'time'],
          'rotate': ['heading_error', 'true_error', 'overshoot', 'time']}
