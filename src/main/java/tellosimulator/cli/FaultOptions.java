package tellosimulator.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultPlan;
import tellosimulator.fault.FaultTextException;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.SimConfig;

/** The command-line options for faults. */
final class FaultOptions {

  private static final String FAULT = "--fault";

  private final OptionValue<Optional<LinkPreset>> link;
  private final OptionValue<List<Fault>> faults;

  FaultOptions(OptionList optionList) {
    link =
        optionList
            .option(
                "--link",
                "ideal|lab|classroom|crowded",
                "How good the link is: nothing lost or late; as measured with one drone; or worse."
                    + " Default: ideal, and lab with --behaviour measured.")
            .readIfGiven(FaultOptions::preset);
    faults =
        optionList
            .option(
                FAULT,
                "TEXT",
                "What goes wrong, where, when and how long, such as \"loss state 20%% drone 2 at 5s"
                    + " for 10s\"; docs/faults.md lists all. Can be given several times.")
            .readEach(FaultOptions::fault);
  }

  /**
   * Returns the faults of a scenario combined with those from the options.
   *
   * @throws IllegalArgumentException if a fault names a drone that does not exist; the message is
   *     one sentence
   */
  FaultPlan applied(FaultPlan written, SimConfig config) {
    int drones = config.drones().size();
    for (Fault fault : faults.value()) {
      OptionalInt drone = fault.target().drone();
      if (drone.isPresent() && drone.getAsInt() > drones) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "%s: there is no drone %d, the drones are 1 to %d",
                FAULT,
                drone.getAsInt(),
                drones));
      }
    }
    List<Fault> all = new ArrayList<>(written.faults());
    all.addAll(faults.value());
    return new FaultPlan(link.value().or(written::link), all);
  }

  private static LinkPreset preset(String word) {
    try {
      return LinkPreset.of(word);
    } catch (FaultTextException e) {
      throw new TypeConversionException(e.getMessage());
    }
  }

  private static Fault fault(String text) {
    try {
      return Fault.of(text);
    } catch (FaultTextException e) {
      throw new TypeConversionException(e.getMessage());
    }
  }
}
