package tellosimulator.recording;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.goal.Score;
import tellosimulator.json.Json;

/**
 * The points of a recorded flight. Immutable.
 *
 * @param takeoff the first takeoff of the attempt, from which the seconds of the score are counted,
 *     in simulated seconds since the simulation began
 */
public record RecordedScore(Score score, double takeoff) {

  /** Returns the members of the score in {@code run.json}; empty if there is none. */
  static Optional<Map<String, Object>> members(Entry.End end) {
    return end.progress()
        .score()
        .map(
            score ->
                Json.object(
                    "points", score.points(),
                    "of", score.of(),
                    "takeoff", end.attemptNanos() * 1e-9,
                    "entries", score.entries().stream().map(RecordedScore::entry).toList()));
  }

  private static Map<String, Object> entry(Score.Entry entry) {
    return Json.object(
        "second", entry.second(),
        "points", entry.points(),
        "why", entry.why().english(),
        "said", RecordedPhrase.members(entry.why()));
  }

  static RecordedScore of(Fields fields) {
    List<Score.Entry> entries =
        fields.objects("entries").stream()
            .map(
                entry ->
                    new Score.Entry(
                        entry.numberOr("second", 0),
                        entry.numberOr("points", 0),
                        entry.phrase("said", "why")))
            .toList();
    Score score = new Score(entries, fields.numberOr("points", 0), fields.numberOr("of", 0));
    return new RecordedScore(score, fields.moment("takeoff").orElse(0));
  }
}
