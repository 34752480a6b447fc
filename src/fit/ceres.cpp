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

namespace {
// One residual block for each observation, because Ceres applies a loss to a block; the model is evaluated
// once for all blocks.
struct Model : ceres::EvaluationCallback {
    const wf_lsq *q;
    const double *p;
    bool failed = false;
    size_t evaluations = 0;
    std::vector<double> r, J;
    Model(const wf_lsq *problem, const double *at)
        : q(problem), p(at), r(problem->residuals), J(problem->residuals * problem->params)
    {
    }
    void PrepareForEvaluation(bool jacobian, bool fresh) override
    {
        if (!jacobian && !fresh) return;
        evaluations++;
        failed = !q->model(q->ctx, p, r.data(), jacobian ? J.data() : nullptr);
    }
};

struct Row : ceres::CostFunction {
    const Model *model;
    size_t i;
    Row(const Model *m, size_t row) : model(m), i(row)
    {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(m->q->params));
    }
    bool Evaluate(double const *const *, double *residual, double **jacobian) const override
    {
        if (model->failed || !std::isfinite(model->r[i])) return false;
        residual[0] = model->r[i];
        const size_t n = model->q->params;
        for (size_t k = 0; jacobian && jacobian[0] && k < n; k++) {
            jacobian[0][k] = model->J[i * n + k];
            if (!std::isfinite(jacobian[0][k])) return false;
        }
        return true;
    }
};

struct Progress : ceres::IterationCallback {
    const wf_lsq *q;
    bool stopped = false;
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &s) override
    {
        stopped = q->progress && q->progress(q->ctx, static_cast<size_t>(s.iteration), s.cost);
        // not SOLVER_ABORT: after an abort Ceres does not return the best parameters so far and their cost
        return stopped ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
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
            return wf_fail(e, WF_EUSAGE, "parameter %zu starts at %g, outside its bounds %g to %g", k + 1, p[k],
                           q->low[k], q->high[k]);
    return WF_OK;
}

wf_status solve(const wf_lsq *q, double *p, wf_lsq_result *out, wf_err *e)
{
    Model model(q, p);
    ceres::Problem::Options owned;
    owned.evaluation_callback = &model;
    ceres::Problem problem(owned);
    const int n = static_cast<int>(q->params);
    problem.AddParameterBlock(p, n);
    for (int k = 0; k < n; k++) {
        problem.SetParameterLowerBound(p, k, q->low[k]);
        problem.SetParameterUpperBound(p, k, q->high[k]);
    }
    for (size_t i = 0; i < q->residuals; i++)
        problem.AddResidualBlock(new Row(&model, i), i + q->plain < q->residuals ? loss_of(q) : nullptr, p);

    ceres::Solver::Options o;
    o.linear_solver_type = ceres::DENSE_QR;
    o.logging_type = ceres::SILENT;
    o.num_threads = 1;
    o.max_num_iterations = q->iterations_max ? static_cast<int>(q->iterations_max) : 100;
    o.function_tolerance = 1e-11;
    o.gradient_tolerance = 1e-14;
    o.parameter_tolerance = 1e-9;
    o.update_state_every_iteration = true;
    Progress progress;
    progress.q = q;
    o.callbacks.push_back(&progress);
    ceres::Solver::Summary s;
    ceres::Solve(o, &problem, &s);

    out->cost0 = s.initial_cost;
    out->cost = s.final_cost;
    out->iterations = s.iterations.size();
    out->evaluations = model.evaluations;
    out->stopped = progress.stopped;
    out->converged = s.termination_type == ceres::CONVERGENCE;
    std::snprintf(out->message, sizeof out->message, "%s", s.message.c_str());
    if (s.termination_type != ceres::FAILURE) return WF_OK;
    if (s.iterations.size() <= 1)
        return wf_fail(e, WF_EINPUT, "the model has no finite answer at the start values");
    return wf_fail(e, WF_ENOCONV, "the fit ended without a result: %s", out->message);
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
