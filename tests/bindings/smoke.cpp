// SPDX-License-Identifier: MIT
// The C++ wrapper: create, evaluate a batch, insert a knot, and be told what is wrong.
#include "expect.hpp"

using libnurbs::Input;
using libnurbs::Output;
using libnurbs::Spline;

static const std::vector<double> circle_points{1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};

// The unit circle as four rational quadratic quarters.
static Spline circle() {
    const double s = std::sqrt(0.5);
    return Spline::create({2}, {9}, libnurbs::knots_bezier(2, 4), 2, circle_points,
                          {1, s, 1, s, 1, s, 1, s, 1});
}

// z = u v over the unit square.
static Spline patch() {
    return Spline::create_bezier({1, 1}, 3, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1});
}

static std::vector<double> samples() {
    std::vector<double> params(1001);
    for (std::size_t i = 0; i < params.size(); ++i) {
        params[i] = static_cast<double>(i) / 1000.0;
    }
    return params;
}

static void known_points() {
    EXPECT((circle().eval({0, 0.25, 0.5, 0.75}) == std::vector<double>{1, 0, 0, 1, -1, 0, 0, -1}));
    const auto derivs = patch().eval_derivs(1, {0.25, 0.5});
    EXPECT((derivs == std::vector<double>{0.25, 0.5, 0.125, 1, 0, 0.5, 0, 1, 0.25}));
    EXPECT((patch().iso(0, 0.5).eval({1}) == std::vector<double>{0.5, 1, 0.5}));
    EXPECT(patch().eval_grid({2, 1}, {0, 1, 0.5}) == patch().eval({0, 0.5, 1, 0.5}));
    EXPECT(patch().eval_grid_derivs(2, {2, 1}, {0, 1, 0.5}) == patch().eval_derivs(2, {0, 0.5, 1, 0.5}));
}

static void single_precision_is_rounded_once() {
    const auto params = samples();
    const auto points = circle().eval(params);
    EXPECT(circle().eval_f32(params) == std::vector<float>(points.begin(), points.end()));
    const auto grid = patch().eval_grid({2, 1}, {0, 0.3, 0.7});
    EXPECT(patch().eval_grid_f32({2, 1}, {0, 0.3, 0.7}) == std::vector<float>(grid.begin(), grid.end()));
}

// L = x + 2 y of a point of the circle at t = 0, the first control point.
static void data_derivatives() {
    const Spline g = circle();
    const auto m = libnurbs::rational_collocation(g, {0, 0.25});
    EXPECT((m.columns == std::vector<std::int64_t>{0, 1, 2, 2, 3, 4}));
    EXPECT((m.row_pointers == std::vector<std::int64_t>{0, 3, 6}));
    EXPECT((m.values == std::vector<double>{1, 0, 0, 1, 0, 0}));
    const auto n = libnurbs::collocation({1, 1}, {2, 2}, {0, 0, 1, 1, 0, 0, 1, 1}, {0.25, 0.5}, {0, 1});
    EXPECT((n.values == std::vector<double>{-0.75, 0.75, -0.25, 0.25}));
    const auto e = libnurbs::bezier_extraction(g, 0);
    EXPECT((e.firsts == std::vector<std::int64_t>{0, 2, 4, 6}) && e.domains[3] == 0.5);
    EXPECT(e.operators.size() == 36 && e.operators[13] == 1 && e.operators[14] == 0);
    const auto gradients = libnurbs::eval_adjoint(g, 0, {0}, {1, 2});
    EXPECT(gradients.points[0] == 1 && gradients.points[1] == 2 && gradients.points[2] == 0);
    EXPECT(std::abs(gradients.params[0] - 16 * std::sqrt(0.5)) < 16 * eps);
    auto twice = gradients.points;
    libnurbs::eval_adjoint(g, 0, {0}, {1, 2}, twice, {}, {}, libnurbs::accumulate);
    EXPECT(twice[0] == 2 && twice[1] == 4);
    EXPECT(error_of([&] { (void)libnurbs::eval_adjoint(g, 0, {0}, {1}); }).status() ==
           libnurbs::Status::size);
    EXPECT(error_of([&] {
               (void)libnurbs::rational_collocation(g, {0}, {1, 1});
           }).status() == libnurbs::Status::size);
}

static void calculus_and_weights() {
    const Spline g = circle();
    const Spline line = patch().iso(0, 0.5); // (0.5, v, 0.5 v)
    EXPECT((libnurbs::blossom(line, std::vector{0.5}, std::vector{0.25}) == std::vector{0.5, 0.25, 0.125}));
    EXPECT((libnurbs::derivative(line, 0).eval({0.3}) == std::vector<double>{0, 1, 0.5}));
    EXPECT((libnurbs::derivative(g, 0).degree(0)) == 4);
    EXPECT((libnurbs::antiderivative(line, 0).eval({1}) == std::vector<double>{0.5, 0.5, 0.25}));
    EXPECT((libnurbs::product(line, line, libnurbs::product_dot).eval({1}) == std::vector<double>{1.5}));
    const Spline square = Spline::create_bezier({2}, 1, {0, 0, 1});
    EXPECT((libnurbs::compose(line, square).eval({0.5}) == std::vector{0.5, 0.25, 0.125}));
    EXPECT((libnurbs::sum(line, 2, line, 1).eval({1}) == std::vector<double>{1.5, 3, 1.5}));
    EXPECT(libnurbs::normalize_weights(line.make_rational()).is_rational() == false);
    const Spline moved = libnurbs::reparametrize_moebius(g, 0, 4);
    EXPECT(std::abs(moved.weights().back() - 4) < 64 * eps);
    EXPECT(std::abs(libnurbs::equalize_end_weights(moved, 0).weights().back() - 1) < 64 * eps);
    EXPECT(error_of([&] { (void)libnurbs::antiderivative(g, 0); }).status() == libnurbs::Status::rational);
}

static void parts_of_the_circle() {
    const Spline g = circle();
    EXPECT(g.refine(0, std::vector{0.6, 0.3}).count(0) == 11 && g.refine_uniform(0, 2).count(0) == 13);
    EXPECT(libnurbs::refinement_matrix(g, 0, std::vector{0.1}).row_pointers.size() == 11);
    const auto [lower, upper] = g.split(0, 0.3);
    const Spline parts[] = {lower, upper};
    const auto joined = libnurbs::join(parts, 0);
    const auto params = samples();
    EXPECT(joined.gap == 0 && near(joined.spline.eval(params), g.eval(params), 8 * eps));
    EXPECT(g.extract(std::vector{0.1}, std::vector{0.2}).count(0) == 3);
    EXPECT(libnurbs::decompose(g).size() == 4 && libnurbs::split_at_knots(g, 0, 0).size() == 1);
    EXPECT(g.clamp(0).count(0) == 9);
    EXPECT(error_of([&] { static_cast<void>(g.move_seam(0, 0.3)); }).status() ==
           libnurbs::Status::not_periodic);
}

static void circles_made_compatible() {
    const Spline both[] = {circle(), circle().insert_knot(0, 0.3, 1)};
    const auto made = libnurbs::make_compatible(both);
    EXPECT(made.deviation == 0 && made.splines.size() == 2 && made.splines[0].count(0) == 10);
    const auto snapped = libnurbs::snap_knots(both[1], 0, 0.06);
    EXPECT(snapped.deviation > 0 && snapped.spline.knots(0)[5] == 0.25);
}

static void continuity_of_the_circle() {
    const auto rows = libnurbs::continuity(circle(), 0);
    EXPECT((rows.orders == std::vector<std::int32_t>{1, 1, 1, 1}) && rows.geometric_orders[3] == 2);
    const auto [lower, upper] = circle().split(0, 0.3);
    EXPECT(libnurbs::continuity_between(lower, libnurbs::end_of_axis, upper, libnurbs::start_of_axis).order ==
           2);
}

static void beyond_the_ends() {
    EXPECT(libnurbs::extend(circle(), 0, libnurbs::end_of_axis, 0.1, 1).domain(0)[1] == 1.1);
    EXPECT(libnurbs::unclamp(circle(), 0).knot_form(0) == 0);
    const auto loop = libnurbs::make_periodic(circle(), 0, 1e-9);
    EXPECT(loop.order == 0 && loop.deviation < 1e-9 && libnurbs::detect_periodic(loop.spline, 0));
}

static void images_in_a_plane() {
    const std::vector<double> origin = {0, 0}, up = {0, 2}, eye = {0, -4};
    EXPECT((libnurbs::mirror(circle(), origin, up).eval({0.25}) == std::vector<double>{0, -1}));
    EXPECT((libnurbs::project_to_plane(circle(), origin, up).eval({0.25}) == std::vector<double>{0, 0}));
    EXPECT((libnurbs::project_to_plane(circle(), origin, up, up).eval({0}) == std::vector<double>{1, 0}));
    EXPECT((libnurbs::project_from(circle(), eye, origin, up).eval({0}) == std::vector<double>{1, 0}));
}

static void segments() {
    const std::vector<double> params = {0, 1}, points = {0, 0, 1, 1}, tangents = {3, 0, 0, 3};
    const Spline g = libnurbs::create_hermite(params, 2, points, tangents);
    EXPECT((g.eval_derivs(1, {0}) == std::vector<double>{0, 0, 3, 0}));
    EXPECT((libnurbs::to_hermite(g).tangents == tangents));
    const libnurbs::PowerForm form = libnurbs::to_power(g);
    EXPECT((form.coefficients == std::vector<double>{0, 0, 3, 0, -3, 0, 1, 1}));
    EXPECT((libnurbs::create_power(std::vector<std::int32_t>{3}, 2, form).eval({1}) ==
            std::vector<double>{1, 1}));
    EXPECT((libnurbs::basis_matrix(libnurbs::basis_bernstein, libnurbs::basis_power, 1) ==
            std::vector<double>{1, 0, -1, 1}));
}

static void reduction() {
    const Spline g = circle();
    const auto back = libnurbs::remove_knot(g.insert_knot(0, 0.3, 2), 0, 0.3, 5, 1e-12);
    EXPECT(back.removed == 2 && back.spline.count(0) == 9 && back.bound <= 1e-12);
    EXPECT(libnurbs::deviation(g, back.spline).at_most <= 1e-12);
    EXPECT(libnurbs::reduce_knots(g.refine_uniform(0, 3), -1, 1e-12).spline.count(0) == 9);
    EXPECT(libnurbs::reduce_degree(g.elevate(0, 1), 0, 1).spline.count(0) == 9);
    EXPECT(libnurbs::simplify(g.elevate(0, 1), 1e-12).spline.degree(0) == 2);
    EXPECT(error_of([&] { (void)libnurbs::remove_knot(g, 0, 0.3, 1, 1); }).status() ==
           libnurbs::Status::not_a_knot);
}

static void insertion_keeps_the_circle() {
    const auto params = samples();
    const Spline before = circle(), after = before.insert_knot(0, 0.3, 2);
    const auto points = after.eval(params);
    EXPECT(after.count(0) == 11);
    EXPECT(near(points, before.eval(params), 8 * eps));
    for (std::size_t i = 0; i < points.size(); i += 2) {
        EXPECT(std::abs(std::hypot(points[i], points[i + 1]) - 1) <= 8 * eps);
    }
}

static void forms_and_maps() {
    const Spline g = circle();
    EXPECT(g.elevate(0, 2).degree(0) == 4);
    EXPECT(g.reverse(0).reverse(0).points() == circle_points);
    EXPECT((g.reverse(0, libnurbs::keep_domain).eval({0.25}) == Values{0, -1}));
    EXPECT((g.reparametrize(0, 1, 5).eval({2}) == Values{0, 1}));
    EXPECT(g.to_homogeneous().from_homogeneous().weights() == g.weights());
    EXPECT(g.make_rational().is_rational() && !g.make_rational().is_homogeneous());
    EXPECT((g.transform(2, Values{0, 1, 2, 0}, Values{10, 20}).eval({0}) == Values{10, 22}));
    EXPECT((g.transform_projective(2, Values{1, 0, 0, 0, 1, 0, 0, 0, 2}).eval({0.25}) == Values{0, 0.5}));
    const std::vector<std::int32_t> bilinear = {1, 1}, swapped = {1, 0};
    const Spline patch = Spline::create_bezier(bilinear, 1, Values{0, 1, 2, 3});
    EXPECT((patch.transpose(swapped).points() == Values{0, 2, 1, 3}));
}

static void arrays_of_any_layout() {
    std::vector<double> columns(8);
    circle().eval({0, 0.25, 0.5, 0.75}, Output(columns, 4, 1, 4));
    EXPECT((columns == std::vector<double>{1, 0, -1, 0, 0, 1, 0, -1}));
    EXPECT(circle().with_points(Input(circle_points, 9, 2, 1)).points() == circle_points);
    // Where the library takes one stride, that of components counts too.
    const Values spread{0, 9, 0.5, 9, 1}, packed{0, 0.5, 1};
    const Input apart(spread, 3, 0, 2);
    Values sizes(5, 9.0);
    circle().hull_size(packed, Output(sizes, 3, 0, 2));
    EXPECT((sizes == Values{1, 9, 1, 9, 1}));
    EXPECT(lengths(circle(), apart) == lengths(circle(), packed));
    EXPECT(libnurbs::bernstein(1, 0, apart) == libnurbs::bernstein(1, 0, packed));
}

static void values_of_a_handle() {
    Spline a = circle();
    const Spline b = a;
    Spline c = std::move(a);
    EXPECT(b.point_count() == 9 && c.dimension() == 2 && a.get() == nullptr);
    a = c;
    EXPECT(a.axes() == 1 && a.degree(0) == 2 && a.is_rational());
    EXPECT(error_of([] { (void)Spline().axes(); }).status() == libnurbs::Status::null);
}

static void inspection() {
    const Spline g = circle();
    const auto distinct = g.distinct_knots(0);
    EXPECT((distinct.knots == std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT((distinct.multiplicities == std::vector<std::int32_t>{3, 2, 2, 2, 3}));
    EXPECT(g.knot_form(0) == (libnurbs::form_clamped_start | libnurbs::form_clamped_end));
    EXPECT(g.domain(0)[1] == 1 && g.greville(0)[1] == 0.125 && g.hull_size({0.1})[0] == 1);
    EXPECT((g.rational_basis({0}).values == std::vector<double>{1, 0, 0}));
}

static void constructors_agree() {
    const Spline g = circle();
    const auto knots = g.knots(0), weights = g.weights();
    const auto d = g.distinct_knots(0);
    const libnurbs::View<double> inner = std::span(knots).subspan(1, knots.size() - 2);
    for (const Spline &other :
         {Spline::create_short({2}, {9}, inner, 2, circle_points, weights),
          Spline::create_multiplicities({2}, {9}, {5}, d.knots, d.multiplicities, 2, circle_points, weights),
          Spline::create_homogeneous({2}, {9}, knots, 2, g.homogeneous_points())}) {
        EXPECT(other.knots(0) == knots);
        EXPECT(near(other.eval({0.1}), g.eval({0.1}), 4 * eps));
    }
}

static void bases() {
    const auto knots = libnurbs::knots_open_uniform(2, 4);
    const auto basis = libnurbs::basis(2, knots, 0, {0, 0.5, 1});
    EXPECT(basis.spans == libnurbs::find_spans(2, knots, {0, 0.5, 1}));
    EXPECT((basis.values == std::vector<double>{1, 0, 0, 0.5, 0.5, 0, 0, 0, 1}));
    EXPECT((libnurbs::bernstein(2, 0, {0.5}) == std::vector<double>{0.25, 0.5, 0.25}));
    EXPECT((libnurbs::knots_uniform(1, 3) == std::vector<double>{-0.5, 0, 0.5, 1, 1.5}));
    EXPECT((libnurbs::knots_periodic(1, {0, 1, 2}) == std::vector<double>{-1, 0, 1, 2, 3}));
    EXPECT((libnurbs::knots_averaged(2, {0, 1, 2, 4}) == std::vector<double>{0, 0, 0, 1.5, 4, 4, 4}));
    EXPECT((libnurbs::knots_bezier(1, {0, 2, 3}) == std::vector<double>{0, 0, 2, 3, 3}));
}

static void frames() {
    const auto f = libnurbs::surface_frames(patch(), {0, 0, 0.5, 0.25});
    EXPECT((std::vector(f.normals.begin(), f.normals.begin() + 3) == std::vector<double>{0, 0, 1}));
    EXPECT((f.status == std::vector<std::int32_t>{0, 0}));
    EXPECT(libnurbs::surface_grid_frames(patch(), {1, 2}, {0.5, 0, 0.25}).du ==
           libnurbs::surface_frames(patch(), {0.5, 0, 0.5, 0.25}).du);
    const auto c = libnurbs::surface_curvatures(patch(), {0, 0});
    EXPECT(std::abs(c.principal[0] - 1) <= 4 * eps && std::abs(c.gaussian[0] + 1) <= 4 * eps);
    const auto t = libnurbs::curve_frames(circle(), {0});
    EXPECT((t.normals == std::vector<double>{-1, 0} && std::abs(t.curvatures[0] - 1) <= 8 * eps));
    const Spline line = Spline::create_bezier({1}, 3, {0, 0, 0, 1, 0, 0});
    EXPECT((libnurbs::curve_frames(line, {0.5}).status[0] == libnurbs::frame_rule));
    EXPECT((libnurbs::rotation_minimizing_frames(line, {0, 1}, {{0, 0, 2}}).normals ==
            std::vector<double>{0, 0, 1, 0, 0, 1}));
    EXPECT(error_of([&] {
               (void)libnurbs::rotation_minimizing_frames(line, {0}, {{1, 0, 0}});
           }).status() == libnurbs::Status::direction);
    std::vector<double> only(5);
    EXPECT(error_of([&] {
               libnurbs::surface_frames(patch(), {0, 0, 1, 1}, {.points = {}, .du = only});
           }).status() == libnurbs::Status::size);
}

static void errors_name_what_is_wrong() {
    std::vector<double> params(20, 0.5), points(40, 7.0);
    params[17] = 1.25;
    const auto error = error_of([&] { circle().eval(params, points); });
    const std::string text = error.what();
    std::cout << error.name() << ": " << text << "\n";
    EXPECT(error.status() == libnurbs::Status::outside_domain);
    EXPECT(text.find("params[17]") != text.npos && text.find("1.25") != text.npos);
    EXPECT(std::ranges::all_of(points, [](double x) { return x == 7.0; }));
    EXPECT((circle().eval({1.25}, libnurbs::clamp) == std::vector<double>{1, 0}));
    points.resize(39);
    EXPECT(error_of([&] { circle().eval(params, points); }).status() == libnurbs::Status::size);
    EXPECT(error_of([&] { (void)circle().eval(Input(params, 20, 2)); }).status() == libnurbs::Status::size);
    EXPECT(error_of([] { (void)libnurbs::List::read_file("/no/such/file"); }).status() ==
           libnurbs::Status::file);
}

// Lengths that follow from wrong numbers are not what the error is about.
static void errors_are_those_of_the_library() {
    const auto curve = circle();
    EXPECT(status_of([] { (void)libnurbs::knots_uniform(-1, 4); }) == libnurbs::Status::degree);
    EXPECT(status_of([] { (void)libnurbs::knots_bezier(2, std::int64_t{-1}); }) == libnurbs::Status::count);
    EXPECT(status_of([&] { (void)curve.eval_grid({-1}, {0.5}); }) == libnurbs::Status::count);
    EXPECT(status_of([] { (void)Spline::create_bezier({-1}, 2, {0, 0}); }) == libnurbs::Status::degree);
    EXPECT(status_of([] {
               (void)libnurbs::create_power({-1}, 2, {{0, 1}, {0, 1}, {1}});
           }) == libnurbs::Status::degree);
}

int main() {
    known_points();
    single_precision_is_rounded_once();
    data_derivatives();
    insertion_keeps_the_circle();
    forms_and_maps();
    calculus_and_weights();
    parts_of_the_circle();
    circles_made_compatible();
    continuity_of_the_circle();
    beyond_the_ends();
    images_in_a_plane();
    segments();
    reduction();
    arrays_of_any_layout();
    values_of_a_handle();
    inspection();
    constructors_agree();
    bases();
    frames();
    errors_name_what_is_wrong();
    errors_are_those_of_the_library();
    return failures == 0 ? 0 : 1;
}
