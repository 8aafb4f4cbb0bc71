"""Programs that print the next number once they have read one, each by other threads."""

# Each reads a number, works, and answers with its successor.
ANSWERS = 'answer = lambda: (sum(range(20000)), print(int(line) + 1, flush=True))\n'
READER = ANSWERS + 'import sys\nfor line in sys.stdin: answer()'
HAND_OVER = ANSWERS + '''
import queue, sys, threading
lines = queue.Queue()
threading.Thread(target=lambda: [lines.put(line) for line in sys.stdin], daemon=True).start()
while True:
    line = lines.get()
    answer()
'''
RING = ANSWERS + '''
import queue, sys, threading
queues = [queue.SimpleQueue() for _ in range(8)]
def pass_on(before, after):
    while True: after.put(before.get())
# Looks go the other way round.
for pair in reversed([*zip(queues, queues[1:])]): threading.Thread(target=pass_on, args=pair, daemon=True).start()
for line in sys.stdin:
    for _ in range(9):
        queues[0].put(line)
        queues[-1].get()
    answer()
'''
POLLER = ANSWERS + '''
import sys, threading, time
lines = []
threading.Thread(target=lambda: [lines.append(line) for line in sys.stdin], daemon=True).start()
while True:
    while not lines: time.sleep(0.01)
    line = lines.pop()
    answer()
'''
# As on a virtual machine whose timers are late now and then.
LATE_POLLER = POLLER.replace('0.01', '0.06 if next(polls) % 10 == 9 else 0.01').replace(
    'lines = []', 'import itertools; polls, lines = itertools.count(), []')
BUSY = 'while True: pass'
COMPUTES = '''
import sys, time
def compute(seconds):
    end = time.process_time() + seconds
    while time.process_time() < end: pass
compute({})
print('ready', flush=True)
for line in sys.stdin: compute({})
'''
NAPPING_THREAD = '''
import threading, time
def work():
    while True: sum(range(100000)), time.sleep(0.01)
threading.Thread(target=work).start()
'''
SLOW_POLLER = 'import time\nwhile True: time.sleep(0.1)'
MANY_THREADS = '''
import sys, threading
for line in sys.stdin:
    thread = threading.Thread(target=lambda: print(int(line) + 1, flush=True))
    thread.start()
'''
NAPPING_THREADS = MANY_THREADS.replace('print', 'time.sleep(0.01) or print').replace('sys,', 'sys, time,')
