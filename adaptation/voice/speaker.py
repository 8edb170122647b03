"""The speaker with a voice: to a sound device, to a WAV file, or to both.

Nothing that breaks stops the story: without a device it goes on to the file, without a voice it
goes on as text, each with one line.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol

from adaptation.storyteller.protocols import Clock, Speaker
from adaptation.voice.sound import GrowingWav, silence
from adaptation.voice.spoken import spoken
from adaptation.voice.voices import Voice
from adaptation.wav import Samples
from personage_lite.errors import PersonageError

# Seconds of silence after each utterance of a WAV file.
_BETWEEN = 0.5


class Output(Protocol):
    """Where sound goes."""

    def play(self, samples: Samples, rate: int) -> None:
        """Begin to play, and return at once; raises `OSError` or `PersonageError`."""
        ...

    def stop(self) -> None:
        """Be silent."""
        ...

    def close(self) -> None:
        """Give the device back; may be called twice."""
        ...


class Loudspeaker:
    """The sound device of this machine, by the package `sounddevice`.

    Raises `PersonageError` if there is none. `sounddevice` is the module, for another one in tests.
    """

    def __init__(self, sounddevice: Any = None) -> None:
        self._module = sounddevice or _sounddevice()
        try:
            self._module.query_devices(kind="output")
        except (self._module.PortAudioError, ValueError):
            raise PersonageError(
                "no sound device, so nothing is heard; plug one in, or write the speech to a file "
                "with --wav FILE"
            ) from None

    def play(self, samples: Samples, rate: int) -> None:
        """Begin to play, and return at once."""
        try:
            self._module.play(samples.astype("float32"), rate)
        except (self._module.PortAudioError, ValueError) as error:
            raise PersonageError(f"the sound device does not play ({error})") from None

    def stop(self) -> None:
        """Be silent."""
        self._module.stop()

    def close(self) -> None:
        """Be silent and give the device back."""
        self._module.stop()


class VoiceSpeaker:
    """Speaks with a voice, beside or instead of a speaker of text.

    `speak` returns when the utterance is over: it waits by `clock.sleep`, so that whoever made the
    clock can use the time. `begin` and `stop` are for a terminal that shows the text meanwhile.
    `say` takes lines for the user.
    """

    def __init__(
        self,
        voice: Voice,
        clock: Clock,
        instead: Speaker,
        say: Callable[[str], None],
        output: Output | None = None,
        wav: GrowingWav | None = None,
    ) -> None:
        self._voice: Voice | None = voice
        self._clock = clock
        self._instead = instead
        self._say = say
        self._output = output
        self._wav = wav
        self._until = -math.inf

    def speak(self, text: str, x: float) -> None:
        """Say one utterance in the style of X in [-2, 2]; returns when it is over."""
        seconds = self.begin(text, x)
        if seconds is None:
            self._instead.speak(text, x)
        else:
            self._clock.sleep(seconds)

    def begin(self, text: str, x: float) -> float | None:
        """Begin to say an utterance; return its length in seconds, or None if the voice is gone."""
        sound = self._sound(text, x)
        if sound is None or self._voice is None:
            return None
        rate = self._voice.rate
        self._write(sound, rate)
        self._play(sound, rate)
        if self._output is None and self._wav is None:
            self._voice = None
            self._say("nothing is left to speak to, so the story goes on as text")
            return None
        seconds = len(sound) / rate
        self._until = self._clock.now() + seconds
        return seconds

    @property
    def speaking(self) -> bool:
        """Whether an utterance is still to be heard: an ear may be deaf meanwhile."""
        return self._clock.now() < self._until

    def stop(self) -> None:
        """Be silent now; the WAV file keeps the whole utterance."""
        self._until = self._clock.now()
        if self._output is not None:
            try:
                self._output.stop()
            except Exception as error:  # a device may break in ways of its own
                self._lose_output(error)

    def close(self) -> None:
        """Finish the WAV file and give the device back; may be called twice."""
        output, wav = self._output, self._wav
        self._output = self._wav = None
        try:
            if output is not None:
                output.close()
        except Exception as error:
            self._say(f"the sound device does not close ({error})")
        finally:
            if wav is not None:
                wav.close()
            self._instead.close()

    def _sound(self, text: str, x: float) -> Samples | None:
        if self._voice is None:
            return None
        try:
            return self._voice.say(spoken(text, x))
        except Exception as error:  # whatever a voice raises, the story goes on
            name, self._voice = self._voice.name, None
            self._say(f"the voice {name} broke ({_reason(error)}); the story goes on as text")
            return None

    def _write(self, sound: Samples, rate: int) -> None:
        if self._wav is None:
            return
        try:
            self._wav.add(sound)
            # A breath between this utterance and the next.
            self._wav.add(silence(_BETWEEN, rate))
        except OSError as error:
            wav, self._wav = self._wav, None
            self._say(f"{wav.path}: no more is written ({_reason(error)}); what is there is whole")
            wav.close()

    def _play(self, sound: Samples, rate: int) -> None:
        if self._output is None:
            return
        try:
            self._output.play(sound, rate)
        except Exception as error:  # a device may break in ways of its own
            self._lose_output(error)

    def _lose_output(self, error: Exception) -> None:
        self._output = None
        self._say(f"no more is heard: {_reason(error)}")


def _reason(error: Exception) -> str:
    return str(getattr(error, "strerror", None) or error or type(error).__name__)


def _sounddevice() -> Any:
    try:
        import sounddevice
    except ModuleNotFoundError as error:
        raise PersonageError(
            f"no sound: sounddevice needs {error.name}; pip install 'personage-lite[voice]'"
        ) from None
    except OSError:
        # The package is there, the library that it calls is not.
        raise PersonageError(
            "no sound: PortAudio is missing; apt-get install libportaudio2"
        ) from None
    return sounddevice
