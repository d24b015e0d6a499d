package tellosimulator.comparison;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import tellosimulator.command.WireText;
import tellosimulator.comparison.FlownCommand.Motion;

/** What a comparison shows of a command, once for each flight, in the order of its columns. */
public enum ComparisonColumn {
  REPLY {
    @Override
    public String text(FlownCommand flown, Locale locale) {
      return WireText.printable(flown.command().reply().stripTrailing());
    }
  },
  /** The duration [s]. */
  SECONDS {
    @Override
    public String text(FlownCommand flown, Locale locale) {
      OptionalDouble seconds = flown.command().duration();
      return seconds.isPresent() ? String.format(locale, "%.2f", seconds.getAsDouble()) : "";
    }
  },
  /** [cm] */
  FORWARD {
    @Override
    public String text(FlownCommand flown, Locale locale) {
      return whole(flown, Motion::forward);
    }
  },
  /** [cm] */
  LEFT {
    @Override
    public String text(FlownCommand flown, Locale locale) {
      return whole(flown, Motion::left);
    }
  },
  /** [cm] */
  UP {
    @Override
    public String text(FlownCommand flown, Locale locale) {
      return whole(flown, Motion::up);
    }
  },
  /** Clockwise [degrees]. */
  TURN {
    @Override
    public String text(FlownCommand flown, Locale locale) {
      return whole(flown, Motion::turn);
    }
  };

  /** The value as people read it; empty if it is not known. */
  public abstract String text(FlownCommand flown, Locale locale);

  private static String whole(FlownCommand flown, ToDoubleFunction<Motion> part) {
    return flown
        .motion()
        .map(motion -> Long.toString(Math.round(part.applyAsDouble(motion))))
        .orElse("");
  }
}
