package tellosimulator.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedRun;
import tellosimulator.recording.RecordedRun.DroneEntry;
import tellosimulator.world.Room;

/** What is said of a flight as a whole: badges, facts and goals. For any thread. */
record ReportSummary(RecordedFlight flight, ReportTexts texts) {

  /** The result, and what went wrong how often. */
  List<Object> badges() {
    List<Object> badges = new ArrayList<>();
    switch (flight.run().result()) {
      case "reached" -> badges.add(badge(texts.of("result.reached"), "good"));
      case "missed" -> badges.add(badge(texts.of("result.missed"), "bad"));
      case "open" -> badges.add(badge(texts.of("result.open"), ""));
      default -> {
        // nothing was asked for
      }
    }
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
    Map<String, Object> badge = new LinkedHashMap<>();
    badge.put("text", text);
    badge.put("mood", mood);
    return badge;
  }

  /** Names and values, in pairs. */
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

  List<Object> goals() {
    List<Object> goals = new ArrayList<>();
    flight
        .goals()
        .forEach(
            goal -> {
              Map<String, Object> members = new LinkedHashMap<>();
              members.put("text", texts.translated(goal.text()));
              goal.reached().ifPresent(time -> members.put("reached", Json.rounded(time)));
              goals.add(members);
            });
    return goals;
  }
}
