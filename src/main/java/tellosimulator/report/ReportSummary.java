package tellosimulator.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.goal.Score;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedRun;
import tellosimulator.recording.RecordedRun.DroneEntry;
import tellosimulator.world.Room;

/** The summary of a flight: badges, facts and goals. Thread-safe. */
record ReportSummary(RecordedFlight flight, ReportTexts texts) {

  /**
   * Returns badges for the result, for the number of failures of each kind, for the duration, and
   * for the number of commands.
   */
  List<Object> badges() {
    List<Object> badges = new ArrayList<>();
    switch (flight.run().result()) {
      case "reached" -> badges.add(badge(texts.of("result.reached"), "good"));
      case "missed" -> badges.add(badge(texts.of("result.missed"), "bad"));
      case "open" -> badges.add(badge(texts.of("result.open"), ""));
      default -> {
        // no goals
      }
    }
    flight.run().score().ifPresent(recorded -> badges.add(badge(total(recorded.score()), "")));
    addCount(badges, "count.crashed", events("crashed"));
    addCount(badges, "count.touched", events("touched"));
    addCount(badges, "count.refused", ReportEntries.count(flight, Outcome.REFUSED));
    addCount(badges, "count.failed", ReportEntries.count(flight, Outcome.FAILED));
    double length = flight.end() - flight.run().started();
    badges.add(badge(texts.of("flew", texts.of("seconds", length)), ""));
    badges.add(badge(commands(), ""));
    return badges;
  }

  private String commands() {
    int count = flight.commands().size();
    return texts.of(count == 1 ? "count.command" : "count.commands", count);
  }

  private void addCount(List<Object> badges, String key, long count) {
    if (count > 0) {
      badges.add(badge(texts.of(key, count), "bad"));
    }
  }

  private long events(String kind) {
    return flight.events().stream().filter(event -> event.kind().equals(kind)).count();
  }

  private static Map<String, Object> badge(String text, String mood) {
    return Json.object("text", text, "mood", mood);
  }

  /** Returns the facts as pairs of a name and a value. */
  List<Object> facts() {
    RecordedRun run = flight.run();
    List<Object> facts = new ArrayList<>();
    addFact(facts, "begun", run.begun());
    addFact(facts, "scenario", run.setting().scenario());
    if (run.realDrone().isPresent()) {
      addFact(facts, "real-drone", run.realDrone().get());
    } else {
      addSimulated(facts, run.setting());
    }
    addFact(facts, "seed", run.seed().map(String::valueOf).orElse(""));
    addFact(facts, "time-factor", run.timeFactor());
    addFact(facts, "options", String.join(" ", run.setting().options()));
    addFact(facts, "program", run.program());
    return facts;
  }

  private void addSimulated(List<Object> facts, RecordedRun.Setting setting) {
    Room room = setting.room();
    addFact(
        facts,
        "room",
        texts.of("room-size", 100 * room.width(), 100 * room.depth(), 100 * room.height()));
    for (DroneEntry drone : setting.drones()) {
      facts.add(List.of(texts.of("drone-number", drone.number()), drone(drone)));
    }
  }

  private String drone(DroneEntry drone) {
    return drone.behavior().isEmpty()
        ? drone.profile()
        : texts.of("product", drone.profile(), drone.behavior());
  }

  private void addFact(List<Object> facts, String key, String value) {
    if (!value.isEmpty()) {
      facts.add(List.of(texts.of("fact." + key), value));
    }
  }

  private String total(Score score) {
    return texts.of("score.total", number(score.points()), number(score.of()));
  }

  private String number(double points) {
    return texts.say(Score.number(points));
  }

  /** Returns the points with a row for each entry; empty if the goals have none. */
  Optional<Map<String, Object>> score() {
    return flight
        .run()
        .score()
        .map(
            recorded ->
                Json.object(
                    "total", total(recorded.score()),
                    "entries",
                        recorded.score().entries().stream()
                            .map(entry -> row(entry, recorded.takeoff()))
                            .toList()));
  }

  private Map<String, Object> row(Score.Entry entry, double takeoff) {
    boolean won = entry.points() > 0;
    return Json.object(
        "t",
        takeoff + entry.second(),
        "won",
        won,
        "points",
        (won ? "+" : "−") + number(Math.abs(entry.points())),
        "why",
        texts.say(entry.why()));
  }

  List<Map<String, Object>> goals() {
    return flight.goals().stream()
        .map(goal -> Json.object("text", texts.say(goal.phrase()), "reached", goal.reached()))
        .toList();
  }
}
