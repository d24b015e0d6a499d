package tellosimulator.view.replay;

import atlantafx.base.theme.Styles;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Comparator;
import java.util.List;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.shape.LineTo;
import javafx.scene.shape.MoveTo;
import javafx.scene.shape.Path;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The controls of a replay: play, pause, speed, and a slider for the whole flight. Confined to the
 * JavaFX thread.
 */
final class TransportBar extends HBox {

  private final FxReplay replay;
  private final Playback playback;
  private final Language language;
  private final Messages messages;
  private final EntryList entries;
  private final Button play;
  private final Slider slider = Nodes.named(new Slider(), "moment");
  private final ProblemLane lane;
  private final Label now = Nodes.named(new Label(), "now", "now");
  private final Label sinceTakeoff = Nodes.named(new Label(), "since-takeoff", "muted");
  private final ChoiceBox<Double> speed = Nodes.named(new ChoiceBox<>(), "speed");
  private boolean following;

  TransportBar(FxReplay replay, Language language, EntryList entries) {
    this.replay = replay;
    this.playback = replay.playback();
    this.language = language;
    this.messages = language.messages(TransportBar.class);
    this.entries = entries;
    this.lane = new ProblemLane(playback, entries.problems());
    play = button("play", playback::toggle);
    Nodes.named(this, "transport", "transport");
    setAlignment(Pos.CENTER);
    slider.setMin(playback.begin());
    slider.setMax(Math.max(playback.begin() + 0.1, playback.end()));
    slider.accessibleTextProperty().bind(messages.text("moment"));
    speed.getItems().setAll(Playback.SPEEDS);
    Nodes.described(speed, messages.text("speed"));
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private static Button button(String id, Runnable action) {
    Button button = Nodes.named(new Button(), id, Styles.BUTTON_ICON, Styles.SMALL);
    button.setOnAction(pressed -> action.run());
    return button;
  }

  private void show(Button button, Ikon icon, String key) {
    button.setGraphic(new FontIcon(icon));
    Nodes.described(button, messages.text(key));
  }

  private void layoutParts() {
    Button earlier = button("earlier", () -> entries.jump(-1));
    Button later = button("later", () -> entries.jump(1));
    show(earlier, Feather.SKIP_BACK, "earlier");
    show(later, Feather.SKIP_FORWARD, "later");
    VBox times = Nodes.unshrinkable(Nodes.styled(new VBox(now, sinceTakeoff), "times"));
    VBox scrubber = new VBox(lane, slider);
    scrubber.setAlignment(Pos.CENTER);
    HBox.setHgrow(scrubber, Priority.ALWAYS);
    getChildren().addAll(play, earlier, later, times, scrubber, Nodes.unshrinkable(speed));
  }

  private void setupEventHandlers() {
    slider
        .valueProperty()
        .addListener(
            (property, before, moment) -> {
              if (!following) {
                playback.seek(moment.doubleValue());
              }
            });
    playback.timeProperty().subscribe(this::follow);
    Nodes.nameItems(speed, language.localeProperty(), this::speedName);
  }

  private void follow() {
    following = true;
    slider.setValue(playback.time());
    following = false;
  }

  private void setupBindings() {
    playback.heldProperty().bind(slider.valueChangingProperty());
    speed.valueProperty().bindBidirectional(playback.speedProperty());
    playback
        .playingProperty()
        .subscribe(
            playing ->
                show(play, playing ? Feather.PAUSE : Feather.PLAY, playing ? "pause" : "play"));
    now.textProperty().bind(messages.text("seconds", playback.timeProperty()));
    sinceTakeoff
        .textProperty()
        .bind(
            playback
                .timeProperty()
                .map(moment -> moment.doubleValue() - replay.flight().takeoff())
                .flatMap(
                    since ->
                        since < 0
                            ? messages.text("before-takeoff", -since)
                            : messages.text("after-takeoff", since)));
  }

  /** Formats a speed factor in the current language. */
  private String speedName(double factor) {
    return new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(language.locale()))
            .format(factor)
        + " \u00d7";
  }

  /**
   * Marks the moments of problems above the slider; a click near a mark seeks to its moment, and a
   * click elsewhere to the clicked moment. Confined to the JavaFX thread.
   */
  private static final class ProblemLane extends Region {

    private static final double HEIGHT = 8;

    /** Maximum distance at which a click hits a mark [px]. Decided: easy to hit. */
    private static final double NEAR = 8;

    private final Playback playback;
    private final List<Double> moments;
    private final Path marks = Nodes.styled(new Path(), "problem-marks");

    /**
     * Creates a lane.
     *
     * @param moments the moments of the problems [s]
     */
    ProblemLane(Playback playback, List<Double> moments) {
      this.playback = playback;
      this.moments = List.copyOf(moments);
      setId("problem-lane");
      setMinHeight(HEIGHT);
      setPrefHeight(HEIGHT);
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

    /** Returns the position of a moment [px]. */
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
}
