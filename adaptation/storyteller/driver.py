"""The driver: joins dialog, sensor, learner, generator, speaker, ear, memory and log.

It knows them by their protocols only; the clock is injected, so that a whole session runs in
simulated time. Source: the paper, section IV and figure 4.
"""

from __future__ import annotations

from collections import deque
from typing import Any

from adaptation.storyteller.dialog import (
    Began,
    Dialog,
    Do,
    Ended,
    Event,
    Heard,
    Listen,
    Say,
    ShowNames,
    Silence,
    Tell,
    Told,
    step,
)
from adaptation.storyteller.learning import Move, belief
from adaptation.storyteller.parts import Parts, Settings, Summary, Times, turn_record
from adaptation.storyteller.prepared import Prepared
from adaptation.storyteller.protocols import EndOfInput
from adaptation.storyteller.protocols import Heard as Answer
from adaptation.storyteller.remarks import Remark, as_answer, heed
from adaptation.storyteller.screen import Status
from adaptation.storyteller.senses import Sensed
from adaptation.storyteller.ticking import CutShort, Interrupted
from adaptation.storyteller.understanding import Meaning, Sense
from personage_lite.errors import PersonageError
from personage_lite.plan import Utterance
from personage_lite.state import ConversationState

# So much of an answer is kept in the log.
_KEPT = 200


class Storyteller:
    """One session, from greeting to farewell."""

    def __init__(
        self, parts: Parts, settings: Settings, state: ConversationState | None = None
    ) -> None:
        self._parts = parts
        self._settings = settings
        self._state = state if state is not None else ConversationState()
        self._dialog = Dialog()
        self._prepared = Prepared(parts.generator, settings.seed)
        self._answers: deque[tuple[Answer, Meaning]] = deque()
        # X of the last utterance, or the present one; None before the first.
        self._spoken: int | None = None
        self._speaking = False
        self._last_end: float | None = None
        self.summary = Summary()

    def run(self) -> Summary:
        """Run until the farewell, the end of the input, or an interruption; returns what came."""
        parts = self._parts
        parts.ear.expect(parts.understanding.phrases)
        try:
            parts.clock.sleep(0.0)
            self._converse(Began(self._settings.known, self._settings.name))
            self.summary.reason = "farewell"
        except EndOfInput:
            self.summary.reason = "end of input"
            # Nobody can answer any more.
            self._converse(Ended())
        except Interrupted:
            self.summary.reason = "interrupted"
        finally:
            self._write("end", reason=self.summary.reason, turns=self.summary.turns)
        return self.summary

    # Called by the clock while anybody waits

    def frame(self) -> None:
        """Hear what is said meanwhile, and prepare what comes next."""
        if not self._speaking:
            return
        self._prepared.prepare_one()
        answer = self._parts.ear.listen(0.0)
        if answer is None:
            return
        meaning = self._take(answer)
        if meaning is not None and meaning.sense in ("quit", "pause", "no", "name"):
            raise CutShort

    # The dialog

    def _converse(self, event: Event | None) -> None:
        while event is not None:
            before = self._dialog.phase
            self._dialog, todo = step(self._dialog, event, self._parts.stories.stock(self._state))
            if self._dialog.phase != before:
                self._write("state", phase=self._dialog.phase, topic=self._dialog.topic)
            self._show()
            event = None
            for each in todo:
                event = self._done(each)
                if event is not None:
                    break

    def _done(self, each: Do) -> Event | None:
        """Do one thing; returns what happened that the dialog must know, if anything."""
        if isinstance(each, Say):
            self._say(each)
        elif isinstance(each, ShowNames):
            self._parts.screen.note(", ".join(self._parts.stories.names()))
        elif isinstance(each, Tell):
            return self._tell(each.character)
        elif isinstance(each, Listen):
            return self._listen(each.patient)
        return None

    def _say(self, act: Say) -> None:
        parts, x, turn = self._parts, self._parts.talk.x, self._state.turn
        said = parts.generator.say(
            act.act,
            character=act.character,
            name=self._settings.name,
            heard=act.heard,
            x=x,
            seed=self._settings.seed,
            state=self._state,
        )
        self._state = said.state
        self._write(
            "say", act=act.act, character=act.character, heard=act.heard, x=x, turn=turn,
            text=said.text,
        )  # fmt: skip
        self._present(said.text, x)
        self._last_end = None

    def _listen(self, patient: bool) -> Event:
        """Wait for an answer; remarks are taken note of, and waited on."""
        limit = None if patient else self._settings.patience
        if self._settings.turns is not None and self.summary.turns >= self._settings.turns:
            return Ended()
        while True:
            if self._answers:
                _, meaning = self._answers.popleft()
                return Heard(meaning)
            answer = self._parts.ear.listen(limit)
            if answer is None:
                return Silence()
            self._take(answer)

    def _take(self, answer: Answer) -> Meaning | None:
        """Understand an answer: a remark is evidence, all else waits for the dialog."""
        parts = self._parts
        prefer: tuple[Sense, ...] = ("resume",) if self._dialog.phase == "paused" else ()
        meaning = parts.understanding.meaning(answer.text, prefer)
        remark = self._remark(answer.text, meaning)
        if remark is not None and self._dialog.phase == "waiting":
            meaning, remark = as_answer(remark, meaning, told=self._spoken is not None)
        evidence = None if remark is None else self._heed(remark, answer.confidence)
        self._write(
            "heard",
            text=answer.text[:_KEPT],
            confidence=answer.confidence,
            source=answer.source,
            sense=meaning.sense if remark is None else "remark",
            name=meaning.name[:_KEPT],
            speaking=self._speaking,
            remark=evidence,
        )
        parts.screen.heard(self._shown(answer, meaning), answer.source == "typed")
        if remark is not None:
            self._show()
            if meaning.sense not in ("yes", "no"):
                return None  # "yes, great!" is both
        self._answers.append((answer, meaning))
        return meaning

    def _shown(self, answer: Answer, meaning: Meaning) -> str:
        """Return an answer as it is shown: the key that paused goes on when it is struck again."""
        if self._dialog.phase == "paused" and meaning.sense == "pause":
            return self._parts.generator.dialog.heard["resume"][0]
        return answer.text

    def _remark(self, text: str, meaning: Meaning) -> Remark | None:
        """Return what an answer says of the telling, unless it says what is to be done."""
        if self._parts.remarks is None or meaning.sense in ("name", "quit", "pause", "who"):
            return None
        return self._parts.remarks.understood(text)

    def _heed(self, remark: Remark, confidence: float) -> dict[str, Any]:
        """Let the learner take a remark as evidence; return it for the log."""
        parts = self._parts
        engagement = parts.senses.engagement or 0.0
        heed(parts.talk.learner, remark, self._spoken, engagement, confidence)
        return {
            "kind": remark.kind,
            "of_that": remark.of_that,
            "x": self._spoken,
            "engagement": engagement,
            "weight": confidence,
        }

    # Telling

    def _tell(self, character: str) -> Event:
        parts, settings = self._parts, self._settings
        if settings.turns is not None and self.summary.turns >= settings.turns:
            return Ended()
        if self._last_end is not None:
            parts.clock.sleep(settings.breath)
        known = parts.senses.engagement
        preference = parts.audience.preference if parts.audience is not None else None
        move = parts.talk.choose(known, preference)
        utterance = self._prepared.get(character, move.x, self._state)
        state, self._state = self._state, utterance.state
        self._spoken = move.x
        self._show()
        self._prepared.expect(character, move.x, utterance.state)
        before, began = parts.senses.begin(), parts.clock.now()
        pause = None if self._last_end is None else began - self._last_end
        if parts.audience is not None:
            parts.audience.listen_to(move.x, parts.seconds(utterance.text, move.x))
        self._present(utterance.text, move.x)
        self._last_end = parts.clock.now()
        times = Times(self._last_end - began, pause)
        sensed = parts.senses.end(before)
        if parts.audience is not None:
            parts.audience.heard_all()
        reward = parts.talk.learn(move, sensed, times.duration)
        self._keep(utterance, state.turn, move, sensed, times, reward, known, preference)
        return Heard(self._answers.popleft()[1]) if self._answers else Told()

    def _keep(
        self, utterance: Utterance, turn: int, move: Move, sensed: Sensed, times: Times,
        reward: float | None, known: float | None, preference: int | None,
    ) -> None:  # fmt: skip
        """Log and remember one turn."""
        parts, summary = self._parts, self.summary
        summary.turns += 1
        summary.spoken += times.duration
        if times.pause is not None:
            summary.pauses.append(times.pause)
        audience = parts.audience
        record = turn_record(
            summary.turns, utterance, turn, move, sensed, times, reward, known,
            belief(parts.talk.learner),
            None
            if audience is None
            else {"preference": preference, "engagement": round(audience.engagement, 4)},
        )  # fmt: skip
        self._write("turn", **record)
        self._remember({**record, "when": self._settings.wall()})
        self._show()

    def _remember(self, record: dict[str, Any]) -> None:
        parts, name = self._parts, self._settings.name
        if parts.memory is None or not name:
            return
        told = {key: dict(counts) for key, counts in self._state.told.items()}
        try:
            parts.memory.remember(name, record, parts.talk.learner.save(), told)
        except PersonageError as error:
            # The story goes on; what was remembered so far is whole.
            parts.memory = None
            parts.screen.note(f"{error} (nothing more of this session is remembered)")

    # Presenting

    def _present(self, text: str, x: int) -> None:
        self._speaking = True
        try:
            self._parts.speaker.speak(text, x)
        except CutShort:
            self._parts.screen.cut()
        finally:
            self._speaking = False

    def _show(self) -> None:
        parts = self._parts
        topic = self._dialog.topic
        parts.screen.status(
            Status(
                phase=self._dialog.phase,
                topic=parts.stories.name(topic) if topic else "",
                x=parts.talk.x if self._spoken is None else self._spoken,
                engagement=parts.senses.engagement,
                belief=belief(parts.talk.learner),
                turns=self.summary.turns,
                preference=None if parts.audience is None else parts.audience.preference,
                fault=parts.senses.fault,
            )
        )

    def _write(self, line: str, **fields: Any) -> None:
        self._parts.log.write(
            line, time=round(self._parts.clock.now(), 3), when=self._settings.wall(), **fields
        )
