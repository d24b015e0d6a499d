package tellosimulator.view.controls;

import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import tellosimulator.model.FlightPhase;

/**
 * A label for a drone's flight phase, in the colour of the phase. Confined to the JavaFX thread.
 */
final class PhaseLabel extends Label {

  private static final PseudoClass IN_THE_AIR = PseudoClass.getPseudoClass("in-the-air");
  private static final PseudoClass IN_TROUBLE = PseudoClass.getPseudoClass("in-trouble");
  private static final PseudoClass OFF = PseudoClass.getPseudoClass("off");

  PhaseLabel() {
    getStyleClass().add("phase");
  }

  /** Sets the colour of a phase; the owner sets the text. */
  void show(FlightPhase phase) {
    pseudoClassStateChanged(OFF, phase == FlightPhase.OFF);
    pseudoClassStateChanged(IN_THE_AIR, phase.motorsOn());
    pseudoClassStateChanged(
        IN_TROUBLE, phase == FlightPhase.FALLING || phase == FlightPhase.CRASHED);
  }
}
