"""What a simulation has to warn of at the moment."""


class CurrentWarnings:
    """Warnings that stand side by side, each until its cause is gone."""

    def __init__(self, publish):
        """Publish that there are none; `publish` takes all of them as one text."""
        self._texts = {}
        self._publish = publish
        publish('')

    def set(self, cause, text):
        """Warn of a cause; an empty text takes that back."""
        self._texts.pop(cause, None)
        if text:
            self._texts[cause] = text
        self._publish('; '.join(self._texts.values()))
