package tellosimulator.view.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Progress;
import tellosimulator.recording.RecordedEvent;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedGoal;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.overlay.ContactMark;
import tellosimulator.view.model.FxMarks;

/** What is marked at the moment that a replay shows. For the JavaFX thread. */
final class ReplayMarks {

  /**
   * A contact and when it was.
   *
   * @param time simulated seconds since the simulation began
   */
  private record Contact(double time, ContactMark mark) {}

  private final FxReplay replay;
  private final Challenge challenge;
  private final List<OptionalDouble> reached;
  private final List<Contact> contacts;

  private ReplayMarks(FxReplay replay) {
    this.replay = replay;
    RecordedFlight flight = replay.flight().flight();
    challenge = flight.scenario().map(Scenario::challenge).orElse(Challenge.NONE);
    reached = reached(flight.goals(), challenge.goals().size());
    contacts = flight.events().stream().flatMap(ReplayMarks::contact).toList();
  }

  static FxMarks of(FxReplay replay) {
    ReplayMarks marks = new ReplayMarks(replay);
    return new FxMarks(marks::progress, marks::contacts);
  }

  /** A recording that was cut off does not say which goals were reached. */
  private static List<OptionalDouble> reached(List<RecordedGoal> goals, int count) {
    List<OptionalDouble> reached = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      reached.add(i < goals.size() ? goals.get(i).reached() : OptionalDouble.empty());
    }
    return reached;
  }

  private static Stream<Contact> contact(RecordedEvent event) {
    boolean crash = event.kind().equals("crashed");
    boolean wanted = crash || event.kind().equals("touched");
    if (!wanted || event.drone().isEmpty()) {
      return Stream.empty();
    }
    int drone = event.drone().getAsInt();
    return event
        .place()
        .map(place -> new Contact(event.time(), new ContactMark(drone, place, crash)))
        .stream();
  }

  private Progress progress() {
    double now = replay.playback().time();
    List<OptionalDouble> until = reached.stream().map(time -> until(time, now)).toList();
    return new Progress(challenge, until, 0, Optional.empty());
  }

  private static OptionalDouble until(OptionalDouble time, double now) {
    return time.isPresent() && time.getAsDouble() <= now ? time : OptionalDouble.empty();
  }

  private List<ContactMark> contacts() {
    double now = replay.playback().time();
    return contacts.stream().takeWhile(contact -> contact.time <= now).map(Contact::mark).toList();
  }
}
