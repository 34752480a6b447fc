/* SPDX-License-Identifier: GPL-3.0-or-later */
// The only C++ of the program: Ceres behind a C header. All input is checked before Ceres is called, because
// its own checks abort the program. Its log messages are discarded.
#include "fit/lsq.h"
#include <ceres/ceres.h>
#include <cmath>
#include <cstdio>
#include <glog/logging.h>
#include <mutex>
#include <new>
#include <vector>

namespace
{
// The model at the point p, whose first `free.size()` coordinates as Ceres has them are x: the parameters
// that are not held. One residual block for each observation, because Ceres applies a loss to a block; the
// model is evaluated once for all blocks.
struct Model : ceres::EvaluationCallback {
    const wf_lsq *q;
    double *p;
    bool failed = false;
    size_t evaluations = 0;
    std::vector<size_t> free;
    std::vector<double> x, r, J;
    Model(const wf_lsq *problem, double *at)
        : q(problem), p(at), r(problem->residuals), J(problem->residuals * problem->params)
    {
    }
    void evaluate(bool jacobian)
    {
        evaluations++;
        failed = !q->model(q->ctx, p, r.data(), jacobian ? J.data() : nullptr);
    }
    void unpack()
    {
        for (size_t c = 0; c < free.size(); c++) p[free[c]] = x[c];
    }
    void PrepareForEvaluation(bool jacobian, bool fresh) override
    {
        if (!jacobian && !fresh) return;
        unpack();
        evaluate(jacobian);
    }
    // Half the sum of the losses, and its derivative by parameter k: g; curvature: that of the squares.
    void slope(size_t k, double *g, double *curvature) const
    {
        *g = *curvature = 0;
        for (size_t i = 0; i < q->residuals; i++) {
            double psi = r[i], bend = 1, by = J[i * q->params + k];
            if (i + q->plain < q->residuals) wf_losses[q->loss].slopes(q->loss_scale, r[i], &psi, &bend);
            *g += psi * by;
            *curvature += by * by;
        }
    }
};

struct Row : ceres::CostFunction {
    const Model *model;
    size_t i;
    Row(const Model *m, size_t row) : model(m), i(row)
    {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(m->free.size()));
    }
    bool Evaluate(double const *const *, double *residual, double **jacobian) const override
    {
        if (model->failed || !std::isfinite(model->r[i])) return false;
        residual[0] = model->r[i];
        for (size_t c = 0; jacobian && jacobian[0] && c < model->free.size(); c++) {
            jacobian[0][c] = model->J[i * model->q->params + model->free[c]];
            if (!std::isfinite(jacobian[0][c])) return false;
        }
        return true;
    }
};

// Bounds by an active set. Ceres projects each step onto the bounds, and beside an active bound nearly all of
// its steps are cut short: it creeps, or ends away from the minimum. So a parameter that has reached its
// bound with the cost falling beyond it is held there and the search goes on with the others; when they have
// converged, held parameters into whose range the cost falls are released. At the end none is left (the
// conditions of Karush, Kuhn and Tucker). Gill, Murray and Wright 1981, Practical Optimization, section 5.2.
struct Bounds {
    const wf_lsq *q;
    std::vector<bool> held;
    explicit Bounds(const wf_lsq *problem) : q(problem), held(problem->params, false) {}

    // Does the cost fall beyond the bound that parameter k is on?
    bool pressed(const Model &m, size_t k) const
    {
        double g, curvature;
        if (m.p[k] > q->low[k] && m.p[k] < q->high[k]) return false;
        m.slope(k, &g, &curvature);
        return m.p[k] <= q->low[k] ? g > 0 : g < 0;
    }
    // Hold the parameters that press on a bound. Returned: is there one that was free?
    bool hold(const Model &m)
    {
        bool any = false;
        for (size_t k = 0; k < q->params; k++)
            if (!held[k] && pressed(m, k)) held[k] = any = true;
        return any;
    }
    // Release the held parameters into whose range the cost falls, by more than the tolerance of the search.
    // Returned: is there one?
    bool release(const Model &m, double tolerance)
    {
        bool any = false;
        for (size_t k = 0; k < q->params; k++) {
            double g, curvature;
            if (!held[k] || pressed(m, k)) continue;
            m.slope(k, &g, &curvature);
            if (!(0.5 * g * g > tolerance * curvature)) continue;
            held[k] = false, any = true;
        }
        return any;
    }
};

struct Progress : ceres::IterationCallback {
    const wf_lsq *q;
    Model *model;
    Bounds *bounds;
    size_t before = 0; // iterations of earlier searches
    bool stopped = false, reached = false;
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &s) override
    {
        stopped = q->progress && q->progress(q->ctx, before + static_cast<size_t>(s.iteration), s.cost);
        // after a successful step the model holds its Jacobian at the new point
        if (s.step_is_successful && s.iteration > 0 && !model->failed) {
            model->unpack();
            reached = bounds->hold(*model);
        }
        // not SOLVER_ABORT: after an abort Ceres does not return the best parameters so far and their cost
        return stopped || reached ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
    }
};

void quiet()
{
    static std::once_flag once;
    std::call_once(once, [] {
        FLAGS_logtostderr = false;
        FLAGS_alsologtostderr = false;
        FLAGS_stderrthreshold = google::NUM_SEVERITIES;
        if (!google::IsGoogleLoggingInitialized()) google::InitGoogleLogging("windfirm");
        for (int s = 0; s < google::NUM_SEVERITIES; s++) google::SetLogDestination(s, "");
    });
}

ceres::LossFunction *loss_of(const wf_lsq *q)
{
    switch (q->loss) {
    case WF_LOSS_HUBER:
        return new ceres::HuberLoss(q->loss_scale);
    case WF_LOSS_CAUCHY:
        return new ceres::CauchyLoss(q->loss_scale);
    case WF_LOSS_TUKEY:
        return new ceres::TukeyLoss(q->loss_scale);
    default:
        return nullptr;
    }
}

wf_status check(const wf_lsq *q, const double *p, wf_err *e)
{
    if (!q->model || !q->low || !q->high || q->params < 1)
        return wf_fail(e, WF_EUSAGE, "a fit needs a model, bounds and at least one free parameter");
    if (q->residuals < q->params)
        return wf_fail(e, WF_EUSAGE, "%zu observations cannot determine %zu parameters", q->residuals,
                       q->params);
    if (q->plain > q->residuals || (q->loss != WF_LOSS_NONE && !(q->loss_scale > 0)))
        return wf_fail(e, WF_EUSAGE, "a robust loss needs a positive scale");
    for (size_t k = 0; k < q->params; k++)
        if (!(std::isfinite(p[k]) && p[k] >= q->low[k] && p[k] <= q->high[k] && q->low[k] < q->high[k]))
            return wf_fail(e, WF_EUSAGE, "parameter %zu starts at %g, outside its bounds %g to %g", k + 1,
                           p[k], q->low[k], q->high[k]);
    return WF_OK;
}

const double function_tolerance = 1e-11;

// Minimise over the parameters that are not held, until one of them presses on a bound.
wf_status search(const wf_lsq *q, Model *model, Progress *progress, size_t most, wf_lsq_result *out,
                 wf_err *e)
{
    const int n = static_cast<int>(model->free.size());
    ceres::Problem::Options owned;
    owned.evaluation_callback = model;
    ceres::Problem problem(owned);
    problem.AddParameterBlock(model->x.data(), n);
    for (int c = 0; c < n; c++) {
        problem.SetParameterLowerBound(model->x.data(), c, q->low[model->free[static_cast<size_t>(c)]]);
        problem.SetParameterUpperBound(model->x.data(), c, q->high[model->free[static_cast<size_t>(c)]]);
    }
    for (size_t i = 0; i < q->residuals; i++)
        problem.AddResidualBlock(new Row(model, i), i + q->plain < q->residuals ? loss_of(q) : nullptr,
                                 model->x.data());

    ceres::Solver::Options o;
    o.linear_solver_type = ceres::DENSE_QR;
    o.logging_type = ceres::SILENT;
    o.num_threads = 1;
    o.max_num_iterations = static_cast<int>(most);
    o.function_tolerance = function_tolerance;
    o.gradient_tolerance = 1e-14;
    o.parameter_tolerance = 1e-9;
    o.update_state_every_iteration = true;
    o.callbacks.push_back(progress);
    ceres::Solver::Summary s;
    ceres::Solve(o, &problem, &s);
    model->unpack();

    if (!out->iterations) out->cost0 = s.initial_cost;
    out->cost = s.final_cost;
    out->iterations += s.iterations.size();
    out->stopped = progress->stopped;
    out->converged = s.termination_type == ceres::CONVERGENCE;
    std::snprintf(out->message, sizeof out->message, "%s", s.message.c_str());
    if (s.termination_type != ceres::FAILURE) return WF_OK;
    if (out->iterations <= 1)
        return wf_fail(e, WF_EINPUT, "the model has no finite answer at the start values");
    return wf_fail(e, WF_ENOCONV, "the fit ended without a result: %s", out->message);
}

// Where all parameters are held there is nothing to search: the cost alone.
void take_cost(const wf_lsq *q, const Model &model, wf_lsq_result *out)
{
    double sum = 0;
    for (size_t i = 0; i < q->residuals; i++)
        sum += i + q->plain < q->residuals ? wf_losses[q->loss].rho(q->loss_scale, model.r[i])
                                           : model.r[i] * model.r[i];
    if (!out->iterations) out->cost0 = 0.5 * sum;
    out->cost = 0.5 * sum;
    out->converged = true;
}

wf_status solve(const wf_lsq *q, double *p, wf_lsq_result *out, wf_err *e)
{
    Model model(q, p);
    Bounds bounds(q);
    Progress progress;
    progress.q = q, progress.model = &model, progress.bounds = &bounds;
    const size_t most = q->iterations_max ? q->iterations_max : 100;
    double cost = INFINITY; // at the last release
    model.evaluate(true);
    if (!model.failed) bounds.hold(model);
    for (;;) {
        model.free.clear(), model.x.clear();
        for (size_t k = 0; k < q->params; k++)
            if (!bounds.held[k]) model.free.push_back(k), model.x.push_back(p[k]);
        progress.before = out->iterations, progress.reached = false;
        wf_status status = WF_OK;
        if (model.free.empty())
            take_cost(q, model, out);
        else
            status = search(q, &model, &progress, most - out->iterations, out, e);
        out->evaluations = model.evaluations;
        if (status || out->stopped || out->iterations >= most) return status;
        if (progress.reached) continue;
        model.evaluate(true); // Ceres may have tried points beyond its result
        out->evaluations = model.evaluations;
        if (model.failed || !(out->cost < cost) || !bounds.release(model, function_tolerance * out->cost))
            return WF_OK;
        cost = out->cost;
    }
}
} // namespace

extern "C" wf_status wf_lsq_solve(const wf_lsq *q, double *p, wf_lsq_result *out, wf_err *e)
try {
    *out = wf_lsq_result{};
    const wf_status bad = check(q, p, e);
    if (bad) return bad;
    quiet();
    struct Silence : google::LogSink {
        void send(google::LogSeverity, const char *, const char *, int, const struct ::tm *, const char *,
                  size_t) override
        {
        }
    } sink;
    struct Listen {
        google::LogSink *s;
        explicit Listen(google::LogSink *to) : s(to) { google::AddLogSink(s); }
        ~Listen() { google::RemoveLogSink(s); }
    } listen(&sink);
    return solve(q, p, out, e);
} catch (const std::bad_alloc &) {
    return wf_fail(e, WF_ENOMEM, "not enough memory for least squares");
} catch (const std::exception &x) {
    return wf_fail(e, WF_EINTERNAL, "least squares: %s", x.what());
} catch (...) {
    return wf_fail(e, WF_EINTERNAL, "least squares: an unknown error");
}
