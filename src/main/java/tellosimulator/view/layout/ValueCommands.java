package tellosimulator.view.layout;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.value.ObservableValue;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.FaultTextException;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.layout.WindowCommand.Group;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Wind;

/**
 * The commands with a typed value, such as {@code wind 2}, {@code speed 5}, {@code battery 40},
 * {@code drone 3}, {@code fault loss state 20%}. Confined to the JavaFX thread.
 */
final class ValueCommands {

  /** Mean wind speed below which the wind has no direction [m/s]. */
  private static final double CALM = 1e-6;

  private final ViewContext context;
  private final Messages messages;

  ValueCommands(ViewContext context, Messages messages) {
    this.context = context;
    this.messages = messages;
  }

  /**
   * Returns the command for a typed word and value; empty if there is no command for the word or if
   * the value is invalid.
   */
  Optional<WindowCommand> read(String typed) {
    int blank = typed.indexOf(' ');
    if (blank < 0) {
      return Optional.empty();
    }
    String verb = typed.substring(0, blank).toLowerCase(Locale.ROOT);
    String value = typed.substring(blank).strip();
    if (means("verbs-wind", verb)) {
      return number(value, 0, Wind.FASTEST).map(this::wind);
    }
    if (means("verbs-time", verb)) {
      return value.equals("max")
          ? Optional.of(timeFactor(TimeFactor.MAX))
          : number(value, TimeFactor.SMALLEST, TimeFactor.LARGEST)
              .map(factor -> timeFactor(new TimeFactor(factor)));
    }
    if (means("verbs-battery", verb)) {
      return number(value, 0, 100).map(this::battery);
    }
    if (means("verbs-drone", verb)) {
      return number(value, 1, context.simulation().drones().size())
          .filter(number -> number == Math.rint(number))
          .map(number -> drone(number.intValue()));
    }
    return means("verbs-fault", verb) ? fault(value) : Optional.empty();
  }

  /** Returns whether a verb matches. The words of both languages are accepted. */
  private boolean means(String key, String verb) {
    return Arrays.asList(messages.now(key).split(" ")).contains(verb);
  }

  /**
   * Parses a number as users type it, with or without a unit; empty if it is invalid or out of
   * range.
   */
  private static Optional<Double> number(String value, double least, double most) {
    String digits = value.replace(',', '.').replaceFirst("\\s*(m/s|%|x|×)$", "");
    try {
      return Optional.of(Double.valueOf(digits)).filter(n -> n >= least && n <= most);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns the command that sets the wind's speed and keeps its direction and gusts. If there was
   * no wind, the new wind blows towards the front wall.
   *
   * @param speed the new speed [m/s]; 0 ends the gusts, too
   */
  WindowCommand wind(double speed) {
    ObservableValue<String> title =
        speed == 0
            ? messages.text("command-calm")
            : text(speed, number -> messages.text("command-wind", number));
    return WindowCommand.of(Group.WIND, title, "wind " + plain(speed), () -> blow(speed));
  }

  private void blow(double speed) {
    Wind before = context.simulation().arenaProperty().get().wind();
    Vec3 mean = before.mean().horizontal();
    Vec3 direction = mean.norm() > CALM ? mean.times(1 / mean.norm()) : new Vec3(1, 0, 0);
    double gusts = speed == 0 ? 0 : before.gusts();
    context.actions().carryOut(new Control.SetWind(new Wind(direction.times(speed), gusts)));
  }

  /** Returns the command that sets the speed of simulated time. */
  WindowCommand timeFactor(TimeFactor factor) {
    ObservableValue<String> title =
        factor.unlimited()
            ? messages.text("command-time-max")
            : text(factor.value(), number -> messages.text("command-time", number));
    String aliases = "time speed " + (factor.unlimited() ? "max" : plain(factor.value()));
    return sending(Group.TIME, title, aliases, () -> new Control.SetTimeFactor(factor));
  }

  private WindowCommand battery(double percent) {
    return sending(
        Group.DRONE,
        text(percent, number -> messages.text("command-battery", number)),
        "",
        () -> new Control.SetBattery(selected().number(), percent));
  }

  private WindowCommand drone(int number) {
    return WindowCommand.of(
        Group.DRONE,
        messages.text("command-drone", number),
        "",
        () ->
            context
                .simulation()
                .selectedProperty()
                .set(context.simulation().drones().get(number - 1)));
  }

  private Optional<WindowCommand> fault(String line) {
    try {
      Fault fault = FaultText.read(line);
      boolean exists = fault.target().drone().orElse(1) <= context.simulation().drones().size();
      return Optional.of(fault)
          .filter(known -> exists)
          .map(
              known ->
                  sending(
                      Group.FAULTS,
                      messages.text("command-fault", known.text()),
                      "",
                      () -> new Control.InjectFault(known)));
    } catch (FaultTextException e) {
      return Optional.empty(); // not completely typed yet
    }
  }

  private WindowCommand sending(
      Group group, ObservableValue<String> title, String aliases, Supplier<Control> control) {
    return WindowCommand.of(group, title, aliases, () -> context.actions().carryOut(control.get()));
  }

  private FxDroneModel selected() {
    return context.simulation().selected();
  }

  /** Returns a text with a number formatted for the language. */
  private ObservableValue<String> text(
      double number, Function<String, ObservableValue<String>> text) {
    return context
        .language()
        .localeProperty()
        .flatMap(
            locale ->
                text.apply(
                    new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(locale))
                        .format(number)));
  }

  /** Formats a number independently of the language. */
  private static String plain(double number) {
    return new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(Locale.ROOT)).format(number);
  }
}
