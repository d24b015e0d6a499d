package tellosimulator.view.log;

import java.util.Locale;
import javafx.beans.property.ReadOnlyObjectProperty;

/** The report of the last recorded flight, for a button in the log's bar. For the JavaFX thread. */
public interface ReportOffer {

  /** Whether there is a report to be opened, or why not. */
  enum Availability {
    /** Flights are not recorded. */
    NOT_RECORDED,
    /** No drone has taken off yet. */
    NO_FLIGHT,
    /** The first flight is not over. */
    IN_FLIGHT,
    /** It is being written. */
    WRITING,
    READY;

    /** Its name in keys of texts. */
    String key() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /** Whether there is one. */
  ReadOnlyObjectProperty<Availability> availabilityProperty();

  /** Writes and opens it; what comes of it is told in the log. */
  void open();
}
