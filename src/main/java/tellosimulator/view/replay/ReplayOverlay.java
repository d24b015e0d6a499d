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
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.view.model.FxOverlayItems;

/**
 * Provides the goals and contacts at the moment that a replay shows. Confined to the JavaFX thread.
 */
final class ReplayOverlay {

  /**
   * A contact and its time.
   *
   * @param time the simulated time since the start of the simulation [s]
   */
  private record Contact(double time, ContactDecal mark) {}

  private final FxReplay replay;
  private final Challenge challenge;
  private final List<OptionalDouble> reached;
  private final List<Contact> contacts;

  private ReplayOverlay(FxReplay replay) {
    this.replay = replay;
    RecordedFlight flight = replay.flight().flight();
    challenge = flight.scenario().map(Scenario::challenge).orElse(Challenge.NONE);
    reached = reached(flight.goals(), challenge.goals().size());
    contacts = flight.events().stream().flatMap(ReplayOverlay::contact).toList();
  }

  static FxOverlayItems of(FxReplay replay) {
    ReplayOverlay marks = new ReplayOverlay(replay);
    return new FxOverlayItems(marks::progress, marks::contacts);
  }

  /**
   * Returns the time at which each goal was reached. The time is empty if the goal was not reached,
   * or if the recording is truncated.
   */
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
        .map(place -> new Contact(event.time(), new ContactDecal(drone, place, crash)))
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

  private List<ContactDecal> contacts() {
    double now = replay.playback().time();
    return contacts.stream().takeWhile(contact -> contact.time <= now).map(Contact::mark).toList();
  }
}
