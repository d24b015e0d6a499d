package tellosimulator.view.controls;

import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import tellosimulator.model.FlightPhase;

/** What a drone is doing, in words and in a colour of its own. For the JavaFX thread. */
final class PhaseLabel extends Label {

  private static final PseudoClass IN_THE_AIR = PseudoClass.getPseudoClass("in-the-air");
  private static final PseudoClass IN_TROUBLE = PseudoClass.getPseudoClass("in-trouble");
  private static final PseudoClass OFF = PseudoClass.getPseudoClass("off");

  PhaseLabel() {
    getStyleClass().add("phase");
  }

  /** Takes the colour of a phase; the words are its owner's. */
  void show(FlightPhase phase) {
    pseudoClassStateChanged(OFF, phase == FlightPhase.OFF);
    pseudoClassStateChanged(IN_THE_AIR, phase.motorsOn());
    pseudoClassStateChanged(
        IN_TROUBLE, phase == FlightPhase.FALLING || phase == FlightPhase.CRASHED);
  }
}
