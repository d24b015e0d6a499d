package tellosimulator.view.replay;

import java.util.Comparator;
import java.util.List;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.shape.LineTo;
import javafx.scene.shape.MoveTo;
import javafx.scene.shape.Path;

/**
 * A mark over the slider for each moment at which something went wrong; a click goes to the
 * nearest. For the JavaFX thread.
 */
final class ProblemLane extends Region {

  private static final double HEIGHT = 8;

  /** So near to a mark a click means it [px]. Decided: a finger's width. */
  private static final double NEAR = 8;

  private final Playback playback;
  private final List<Double> moments;
  private final Path marks = new Path();

  /**
   * @param moments at which something went wrong [s]
   */
  ProblemLane(Playback playback, List<Double> moments) {
    this.playback = playback;
    this.moments = List.copyOf(moments);
    setId("problem-lane");
    setMinHeight(HEIGHT);
    setPrefHeight(HEIGHT);
    marks.getStyleClass().add("problem-marks");
    marks.setManaged(false);
    getChildren().add(marks);
    setOnMouseClicked(this::clicked);
  }

  private void clicked(MouseEvent click) {
    double x = click.getX();
    moments.stream()
        .filter(moment -> Math.abs(x(moment) - x) <= NEAR)
        .min(Comparator.comparingDouble(moment -> Math.abs(x(moment) - x)))
        .ifPresentOrElse(playback::seek, () -> playback.seek(moment(x)));
  }

  /** Where a moment is [px]. */
  private double x(double moment) {
    double length = Math.max(1e-3, playback.end() - playback.begin());
    double part = Math.max(0, Math.min(1, (moment - playback.begin()) / length));
    return getInsets().getLeft() + part * inner();
  }

  private double moment(double x) {
    double part = (x - getInsets().getLeft()) / Math.max(1, inner());
    return playback.begin() + part * (playback.end() - playback.begin());
  }

  private double inner() {
    return getWidth() - getInsets().getLeft() - getInsets().getRight();
  }

  @Override
  protected void layoutChildren() {
    marks.getElements().clear();
    for (double moment : moments) {
      double x = Math.floor(x(moment)) + 0.5;
      marks.getElements().addAll(new MoveTo(x, 0), new LineTo(x, getHeight()));
    }
  }
}
