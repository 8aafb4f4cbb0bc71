"""Where a demo leaves its recording."""

import time

from odometry_launch.folders import new_folder


def test_demos_of_the_same_second_have_a_folder_each(tmp_path, monkeypatch):
    """Two that wrote one bag spoiled it."""
    monkeypatch.setattr(time, 'strftime', lambda _: '2026-11-21_12-22-37')
    folders = [new_folder(tmp_path / 'runs') for _ in range(3)]
    assert [folder.name for folder in folders] == [
        '2026-11-21_12-22-37', '2026-11-21_12-22-37_2', '2026-11-21_12-22-37_3']
    assert all(folder.is_dir() for folder in folders)
