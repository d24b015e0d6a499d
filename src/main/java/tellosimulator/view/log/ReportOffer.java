package tellosimulator.view.log;

import java.util.Locale;
import javafx.beans.property.ReadOnlyObjectProperty;

/**
 * Provides the report of the last recorded flight for a button in the log's bar. Confined to the
 * JavaFX thread.
 */
public interface ReportOffer {

  /** Whether the report is available, and if not, why. */
  enum Availability {
    /** Flights are not recorded. */
    NOT_RECORDED,
    /** No drone has taken off yet. */
    NO_FLIGHT,
    /** The first flight is not over yet. */
    IN_FLIGHT,
    /** The report is being written. */
    WRITING,
    READY;

    /** Returns the name used in message keys. */
    String key() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /** The availability of the report. */
  ReadOnlyObjectProperty<Availability> availabilityProperty();

  /** Writes and opens the report; the outcome is logged. */
  void open();
}
