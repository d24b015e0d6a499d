package tellosimulator.scenario;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Scoring;
import tellosimulator.goal.Scoring.Bonus;
import tellosimulator.goal.Scoring.Limits;
import tellosimulator.goal.Scoring.Par;
import tellosimulator.words.Phrase;

/** Codec of the rules by which points are lost and won. */
final class ScoringCodec extends RecordCodec<Scoring> {

  private final Map<Infraction, Field<Scoring, Double>> penalties = new EnumMap<>(Infraction.class);

  ScoringCodec() {
    super(
        "scoring",
        Phrase.of("scoring"),
        "Points, in addition to those of the goals, that are lost for mistakes and time, and won for speed.");
    penalty(Infraction.TOUCH, "touch", "Points lost each time a drone touches anything in flight.");
    penalty(Infraction.CRASH, "crash", "Points lost when a drone crashes.");
    penalty(Infraction.REFUSED, "refused", "Points lost for each command answered by an error.");
    penalty(
        Infraction.NOT_LANDED,
        "not-landed",
        "Points lost for each drone that its program does not land.");
    Field<Scoring, Double> par =
        key(
                "par",
                "Time in seconds, counted from the first takeoff, after which time costs points.")
            .optional(
                NumberCodec.seconds(Quantity.TIME_LIMIT),
                scoring -> scoring.par().map(Par::seconds));
    Field<Scoring, Double> eachSecond =
        key("each-second", "Points lost for each second after par.")
            .optional(NumberCodec.POINTS, scoring -> scoring.par().map(Par::eachSecond));
    add(Case.with(par.key()).needs(eachSecond.key()));
    add(Case.without(par.key()).excludes(eachSecond.key()));
    Field<Scoring, Bonus> bonus =
        key("bonus", "Points for reaching all goals in a short time.")
            .optional(bonus(), Scoring::bonus);
    Field<Scoring, Double> least =
        key("least", "Minimum total.")
            .usual(
                new NumberCodec(
                        Quantity.TOTAL,
                        Phrase.of(
                            "points from %s to %s",
                            NumberCodec.plain(Quantity.TOTAL.least()),
                            NumberCodec.plain(Quantity.TOTAL.most())))
                    .or(Limits.DEFAULT.least()),
                scoring -> scoring.limits().least());
    Field<Scoring, Double> most =
        key("most", "Maximum total.")
            .optional(
                NumberCodec.POINTS,
                scoring -> Optional.of(scoring.limits().most()).filter(Double::isFinite));
    checked(
        in -> {
          if (in.get(least) > in.find(most).orElse(Limits.DEFAULT.most())) {
            in.diagnostics().add(in.nodes().get(most.key()), Phrase.of("most is less than least"));
          }
        });
    made(
        in ->
            new Scoring(
                penalties(in),
                in.find(par).map(seconds -> new Par(seconds, in.get(eachSecond))),
                in.find(bonus),
                new Limits(in.get(least), in.find(most).orElse(Limits.DEFAULT.most()))));
  }

  private void penalty(Infraction infraction, String key, String description) {
    penalties.put(
        infraction,
        key(key, description)
            .optional(
                NumberCodec.POINTS,
                scoring -> Optional.ofNullable(scoring.penalties().get(infraction))));
  }

  private Map<Infraction, Double> penalties(Entries in) {
    Map<Infraction, Double> found = new EnumMap<>(Infraction.class);
    penalties.forEach(
        (infraction, field) -> in.find(field).ifPresent(points -> found.put(infraction, points)));
    return found;
  }

  private static Codec<Bonus> bonus() {
    RecordCodec<Bonus> codec =
        new RecordCodec<>(
            "bonus",
            Phrase.of("a bonus"),
            "Points that decrease linearly between two times, counted from the first takeoff.");
    NumberCodec time = NumberCodec.seconds(Quantity.BONUS_TIME);
    Field<Bonus, Double> points =
        codec.key("points", "Maximum number of points.").need(NumberCodec.POINTS, Bonus::points);
    Field<Bonus, Double> fullUntil =
        codec
            .key("full-until", "Time in seconds up to which all points are won.")
            .need(time, Bonus::fullUntil);
    Field<Bonus, Double> noneFrom =
        codec
            .key("none-from", "Time in seconds from which no points are won.")
            .need(time, Bonus::noneFrom);
    codec.checked(
        in -> {
          if (in.get(fullUntil) >= in.get(noneFrom)) {
            in.diagnostics()
                .add(
                    in.nodes().get(noneFrom.key()),
                    Phrase.of("none-from must be later than full-until"));
          }
        });
    return codec.made(in -> new Bonus(in.get(points), in.get(fullUntil), in.get(noneFrom)));
  }
}
