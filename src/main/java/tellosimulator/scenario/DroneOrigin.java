package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.sim.DroneSetup;

/**
 * Where a drone of an opened scenario comes from: how it was opened, and how the document has it,
 * which differ in what options say about all scenarios. Immutable; for any thread.
 *
 * @param opened as it was opened
 * @param station where it takes commands
 * @param written as the document has it
 * @param writtenStation where it takes commands after the document
 */
public record DroneOrigin(
    DroneSetup opened, Station station, DroneSetup written, Station writtenStation) {

  /** Those of all drones of a scenario, of which the document has as many. */
  static List<DroneOrigin> of(Scenario written, Scenario opened) {
    List<DroneOrigin> origins = new ArrayList<>();
    for (int i = 0; i < opened.stations().size(); i++) {
      origins.add(
          new DroneOrigin(
              opened.config().drones().get(i),
              opened.stations().get(i),
              written.config().drones().get(i),
              written.stations().get(i)));
    }
    return List.copyOf(origins);
  }

  /** Another drone of the same product: at the address, and in the colour, of its own number. */
  public DroneOrigin another() {
    return new DroneOrigin(
        opened.withColor(OptionalInt.empty()),
        new Station(Optional.empty(), station.port()),
        written.withColor(OptionalInt.empty()),
        new Station(Optional.empty(), writtenStation.port()));
  }

  /**
   * The same in another colour.
   *
   * @param rgb as one writes #rrggbb
   */
  public DroneOrigin painted(int rgb) {
    return new DroneOrigin(
        opened.withColor(OptionalInt.of(rgb)),
        station,
        written.withColor(OptionalInt.of(rgb)),
        writtenStation);
  }

  /** What is to be saved of the drone as it is now, so that no option gets into a file. */
  DroneSetup toSave(DroneSetup now) {
    return written
        .withStart(EditedScenario.changed(written.start(), opened.start(), now.start()))
        .withProduct(EditedScenario.changed(written.product(), opened.product(), now.product()))
        .withStreamPorts(
            EditedScenario.changed(written.streamPorts(), opened.streamPorts(), now.streamPorts()));
  }
}
