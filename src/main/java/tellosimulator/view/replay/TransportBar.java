package tellosimulator.view.replay;

import atlantafx.base.theme.Styles;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.util.StringConverter;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** Plays, pauses and scrubs a replay: the slider over the whole flight. For the JavaFX thread. */
final class TransportBar extends HBox {

  private final FxReplay replay;
  private final Playback playback;
  private final Language language;
  private final Messages messages;
  private final EntryList entries;
  private final Button play = new Button();
  private final Button earlier = new Button();
  private final Button later = new Button();
  private final Slider slider = new Slider();
  private final ProblemLane lane;
  private final Label now = new Label();
  private final Label sinceTakeoff = new Label();
  private final ChoiceBox<Double> speed = new ChoiceBox<>();
  private boolean following;

  TransportBar(FxReplay replay, Language language, EntryList entries) {
    this.replay = replay;
    this.playback = replay.playback();
    this.language = language;
    this.messages = language.messages(TransportBar.class);
    this.entries = entries;
    this.lane = new ProblemLane(playback, entries.problems());
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeSelf() {
    setId("transport");
    getStyleClass().add("transport");
    setAlignment(Pos.CENTER);
  }

  private void initializeParts() {
    prepare(play, "play");
    prepare(earlier, "earlier");
    prepare(later, "later");
    show(earlier, Feather.SKIP_BACK, "earlier");
    show(later, Feather.SKIP_FORWARD, "later");
    slider.setId("moment");
    slider.setMin(playback.begin());
    slider.setMax(Math.max(playback.begin() + 0.1, playback.end()));
    slider.accessibleTextProperty().bind(messages.text("moment"));
    now.setId("now");
    now.getStyleClass().add("now");
    sinceTakeoff.setId("since-takeoff");
    sinceTakeoff.getStyleClass().add("muted");
    speed.setId("speed");
    speed.getItems().setAll(Playback.SPEEDS);
    speed.accessibleTextProperty().bind(messages.text("speed"));
    Tooltips.install(speed, messages.text("speed"));
  }

  private static void prepare(Button button, String id) {
    button.setId(id);
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.SMALL);
  }

  private void show(Button button, Ikon icon, String key) {
    button.setGraphic(new FontIcon(icon));
    Tooltips.install(button, messages.text(key));
    button.accessibleTextProperty().bind(messages.text(key));
  }

  private void layoutParts() {
    VBox times = new VBox(now, sinceTakeoff);
    times.getStyleClass().add("times");
    times.setMinWidth(USE_PREF_SIZE);
    VBox scrubber = new VBox(lane, slider);
    scrubber.setAlignment(Pos.CENTER);
    HBox.setHgrow(scrubber, Priority.ALWAYS);
    speed.setMinWidth(USE_PREF_SIZE);
    getChildren().addAll(play, earlier, later, times, scrubber, speed);
  }

  private void setupEventHandlers() {
    play.setOnAction(action -> playback.toggle());
    earlier.setOnAction(action -> entries.jump(-1));
    later.setOnAction(action -> entries.jump(1));
    slider
        .valueProperty()
        .addListener(
            (property, before, moment) -> {
              if (!following) {
                playback.seek(moment.doubleValue());
              }
            });
    playback.timeProperty().subscribe(this::follow);
    language.localeProperty().subscribe(locale -> speed.setConverter(new SpeedNames()));
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

  /** How many times as fast, as people who speak the language write it. */
  private final class SpeedNames extends StringConverter<Double> {
    @Override
    public String toString(Double factor) {
      DecimalFormat format =
          new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(language.locale()));
      return factor == null ? "" : format.format(factor) + " \u00d7";
    }

    @Override
    public Double fromString(String name) {
      throw new UnsupportedOperationException("speeds are chosen, not typed");
    }
  }
}
